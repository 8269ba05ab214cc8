// tolerance: 0.015
// A room that is lit by the sun and the sky through one window alone.
#version 3.7;
#include "quality.inc"
camera { location <2.6, 1.6, -3.4> look_at <-0.6, 1.1, 0.5> angle 68 }
sky_sphere { pigment { gradient y color_map { [0 rgb <0.5, 0.6, 0.75>] [1 rgb <0.25, 0.45, 0.9>] } } }
light_source { <-60, 55, -20>, rgb <3.2, 2.9, 2.4> parallel point_at 0 }
difference {
  box { <-3.2, -0.2, -4.2>, <3.2, 3.2, 4.2> }
  box { <-3, 0, -4>, <3, 3, 4> }
  box { <-4, 0.9, -1.2>, <-2, 2.4, 1.2> }
  pigment { rgb <0.85, 0.83, 0.78> }
}
box { <-3, 0, -4>, <3, 0.01, 4> pigment { checker rgb <0.55, 0.3, 0.15>, rgb <0.65, 0.4, 0.2> scale 0.5 } }
box { <-0.8, 0.7, 1>, <0.8, 0.78, 2> pigment { rgb <0.6, 0.15, 0.1> } }
union {
  cylinder { <-0.7, 0, 1.1>, <-0.7, 0.7, 1.1>, 0.05 }
  cylinder { <0.7, 0, 1.1>, <0.7, 0.7, 1.1>, 0.05 }
  cylinder { <-0.7, 0, 1.9>, <-0.7, 0.7, 1.9>, 0.05 }
  cylinder { <0.7, 0, 1.9>, <0.7, 0.7, 1.9>, 0.05 }
  pigment { rgb 0.3 }
}
sphere { <0.1, 1.03, 1.5>, 0.25 pigment { rgb <0.9, 0.85, 0.3> } }
plane { y, -0.3 pigment { rgb <0.25, 0.4, 0.15> } }
