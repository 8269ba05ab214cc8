// tolerance: 0.015
// An overcast day: no light source, shapes stand in the light of the sky.
#version 3.7;
#include "quality.inc"
camera { location <0, 3.2, -7> look_at <0, 0.8, 0> angle 50 }
sky_sphere { pigment { gradient y color_map { [0 rgb <0.75, 0.78, 0.8>] [1 rgb <0.9, 0.95, 1.1>] } } }
plane { y, 0 pigment { rgb <0.6, 0.58, 0.52> } }
sphere { <-1.9, 0.9, 0.3>, 0.9 pigment { rgb <0.8, 0.25, 0.2> } }
torus { 0.7, 0.28 translate <0.3, 0.28, -1.2> pigment { rgb <0.25, 0.45, 0.8> } }
cone { <1.9, 0, 0.2>, 0.8, <1.9, 1.9, 0.2>, 0 pigment { rgb <0.85, 0.75, 0.3> } }
box { <-0.6, 0, 1>, <0.6, 1.8, 2> rotate 20*y pigment { rgb 0.8 } }
box { <-0.9, 1.8, 0.8>, <0.9, 2, 2.2> rotate 20*y pigment { rgb 0.7 } }
