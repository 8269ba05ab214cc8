// tolerance: 0.015
// Rooms as of paper in bright light: nothing of it may come through walls or under their edges.
#version 3.7;
#include "quality.inc"
camera { location <0, 5.5, -6.5> look_at <0, 0.4, -0.2> angle 46 }
background { rgb <0.9, 0.95, 1> }
light_source { <-30, 50, -20>, rgb 1.2 }
plane { y, 0 pigment { rgb 0.8 } }
#declare Wall = 0.004;
#macro Room(X, Roof)
  union {
    box { <-1, 0, -1>, <-1 + Wall, 1.2, 1> }
    box { <1 - Wall, 0, -1>, <1, 1.2, 1> }
    box { <-1, 0, 1 - Wall>, <1, 1.2, 1> }
    #if (Roof) box { <-1, 1.2, -0.5>, <1, 1.2 + Wall, 1> } #end
    pigment { rgb <0.9, 0.9, 0.85> }
    translate X*x
  }
#end
Room(-1.2, 1)
Room(1.2, 0)
polygon { 5, <-1, 0>, <1, 0>, <1, 0.8>, <-1, 0.8>, <-1, 0> rotate 90*y translate <1.2, 0, 0> pigment { rgb <0.9, 0.2, 0.1> } }
