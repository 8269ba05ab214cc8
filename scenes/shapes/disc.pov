// Discs: with and without a hole, slanted.
#version 3.7;
global_settings { assumed_gamma 1.0 }

camera { location <0, 2.5, -6> right x*4/3 look_at <0, 0.6, 0> angle 54 }
light_source { <-6, 9, -8>, rgb 1 }
plane { y, 0 pigment { checker rgb <0.75, 0.72, 0.65> rgb <0.35, 0.38, 0.42> } }

disc { <0, 1.2, 0>, <0.3, 0.5, -1>, 1.1, 0.5 pigment { rgb <0.85, 0.35, 0.2> } finish { specular 0.4 roughness 0.03 } }
disc { <-2, 0.8, 0>, <1, 0.6, -1>, 0.7 pigment { rgb <0.2, 0.5, 0.85> } }
disc { <2, 0.3, 0>, y, 0.9 scale <1, 1, 0.5> rotate x*-20 pigment { rgb <0.3, 0.75, 0.35> } }
