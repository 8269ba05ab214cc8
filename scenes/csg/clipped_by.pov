// Clipping opens a solid: the inner side becomes visible; a clipped shadow.
#version 3.7;
global_settings { assumed_gamma 1.0 }

camera { location <0, 2.5, -6> right x*4/3 look_at <0, 0.6, 0> angle 54 }
light_source { <-6, 9, -8>, rgb 1 }
plane { y, 0 pigment { checker rgb <0.75, 0.72, 0.65> rgb <0.35, 0.38, 0.42> } }

sphere { 0, 1 clipped_by { plane { <0.3, 1, -0.6>, 0.2 } } translate <-1.2, 1, 0> pigment { rgb <0.85, 0.35, 0.2> } finish { specular 0.4 roughness 0.03 } }
union { torus { 0.7, 0.25 } cylinder { -y, y, 0.2 } clipped_by { box { <-2, -0.6, -2>, <0.3, 0.6, 2> } } rotate x*-30 translate <1.3, 0.8, 0> pigment { rgb <0.9, 0.75, 0.3> } }
