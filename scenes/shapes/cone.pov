// Cones: pointed, truncated, open, double through the tip.
#version 3.7;
global_settings { assumed_gamma 1.0 }

camera { location <0, 2.5, -6> right x*4/3 look_at <0, 0.6, 0> angle 54 }
light_source { <-6, 9, -8>, rgb 1 }
plane { y, 0 pigment { checker rgb <0.75, 0.72, 0.65> rgb <0.35, 0.38, 0.42> } }

cone { <0, 0, 0>, 1, <0, 2, 0>, 0 pigment { rgb <0.85, 0.35, 0.2> } finish { specular 0.4 roughness 0.03 } }
cone { <-2, 0, 0>, 0.4, <-2, 1.3, 0>, 0.8 pigment { rgb <0.2, 0.5, 0.85> } }
cone { <1.9, 0, 0>, 0.8, <1.9, 1, 0.4>, 0.3 open pigment { rgb <0.3, 0.75, 0.35> } }
cone { <0.9, 0.4, -1.8>, 0.4, <1.7, 0.4, -1.8>, -0.4 pigment { rgb <0.8, 0.75, 0.3> } }
