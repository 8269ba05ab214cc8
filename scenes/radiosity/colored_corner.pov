// tolerance: 0.003
// Two coloured walls and a white floor in sunlight: their colours bleed into the floor and into the ball.
#version 3.7;
#include "quality.inc"
camera { location <3.4, 2.6, -3.4> look_at <-0.6, 0.7, 0.6> angle 48 }
background { rgb <0.15, 0.18, 0.22> }
light_source { <25, 40, -30>, rgb 1.6 }
plane { y, 0 pigment { rgb 0.9 } }
box { <-2.1, 0, -3>, <-2, 2.4, 2> pigment { rgb <0.85, 0.08, 0.05> } }
box { <-2, 0, 2>, <3, 2.4, 2.1> pigment { rgb <0.05, 0.12, 0.8> } }
sphere { <-0.5, 0.8, 0.5>, 0.8 pigment { rgb 0.9 } }
cylinder { <1.3, 0, 0.9>, <1.3, 1.1, 0.9>, 0.4 pigment { rgb 0.9 } }
