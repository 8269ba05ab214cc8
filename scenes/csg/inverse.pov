// An inverse solid turns intersection into subtraction; double inversion changes nothing visible.
#version 3.7;
global_settings { assumed_gamma 1.0 }

camera { location <0, 2.5, -6> right x*4/3 look_at <0, 0.6, 0> angle 54 }
light_source { <-6, 9, -8>, rgb 1 }
plane { y, 0 pigment { checker rgb <0.75, 0.72, 0.65> rgb <0.35, 0.38, 0.42> } }

intersection { box { -0.8, 0.8 } sphere { 0, 1 inverse } rotate y*30 translate <-1.2, 0.8, 0> pigment { rgb <0.85, 0.35, 0.2> } finish { specular 0.4 roughness 0.03 } }
intersection { sphere { 0, 0.9 } union { box { <-1, 0, -1>, <0, 1, 0> } box { <0, -1, -1>, <1, 0, 0> } inverse } translate <1.2, 0.9, 0> pigment { rgb <0.9, 0.75, 0.3> } }
