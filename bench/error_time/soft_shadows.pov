// A ring of posts under a wide light. Grid: samples along each side of the light.
#version 3.7;
#ifndef (Grid) #declare Grid = 5; #end
global_settings { assumed_gamma 1 }
camera { location <0, 5, -7> look_at <0, 0.3, 0> angle 45 }
light_source { <4, 9, -3>, 1 area_light 3*x, 3*z, Grid, Grid adaptive 1 jitter circular orient }
plane { y, 0 pigment { rgb 0.8 } }
#for (I, 0, 8)
  cylinder { 0, <0, 0.6 + 0.2*I, 0>, 0.15 translate 2*x rotate 40*I*y pigment { rgb <0.7, 0.4, 0.2> } }
#end
