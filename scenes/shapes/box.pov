// Boxes: corners in any order, rotated, flat.
#version 3.7;
global_settings { assumed_gamma 1.0 }

camera { location <0, 2.5, -6> right x*4/3 look_at <0, 0.6, 0> angle 54 }
light_source { <-6, 9, -8>, rgb 1 }
plane { y, 0 pigment { checker rgb <0.75, 0.72, 0.65> rgb <0.35, 0.38, 0.42> } }

box { <1, 2, 1>, <-1, 0, -1> rotate y*25 pigment { rgb <0.85, 0.35, 0.2> } finish { specular 0.4 roughness 0.03 } }
box { -0.5, 0.5 rotate <45, 0, 35> translate <2.1, 0.9, 0> pigment { rgb <0.2, 0.5, 0.85> } }
box { <-2.6, 0, -1>, <-1.4, 1.5, -1> pigment { rgb <0.3, 0.75, 0.35> } }
