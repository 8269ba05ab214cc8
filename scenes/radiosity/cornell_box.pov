// tolerance: 0.008
// A closed room with a red and a green wall, two blocks, and a lamp under the ceiling.
#version 3.7;
#include "quality.inc"
camera { location <0, 2.5, -8.5> look_at <0, 2.5, 0> angle 42 }
#declare White = pigment { rgb 0.9 }
box { <-2.5, -0.1, -9>, <2.5, 0, 2.5> pigment { White } }
box { <-2.5, 5, -9>, <2.5, 5.1, 2.5> pigment { White } }
box { <-2.5, 0, 2.5>, <2.5, 5, 2.6> pigment { White } }
box { <-2.5, 0, -9.1>, <2.5, 5, -9> pigment { White } }
box { <-2.6, 0, -9>, <-2.5, 5, 2.6> pigment { rgb <0.8, 0.1, 0.08> } }
box { <2.5, 0, -9>, <2.6, 5, 2.6> pigment { rgb <0.12, 0.6, 0.12> } }
box { <-0.75, 0, -0.75>, <0.75, 3, 0.75> rotate 18*y translate <-0.9, 0, 1> pigment { White } }
box { <-0.7, 0, -0.7>, <0.7, 1.4, 0.7> rotate -16*y translate <0.95, 0, -0.6> pigment { White } }
light_source {
  <0, 4.8, 0>, rgb <1, 0.85, 0.6>
  area_light 1.2*x, 1.2*z, 4, 4
  fade_distance 3 fade_power 2
}
