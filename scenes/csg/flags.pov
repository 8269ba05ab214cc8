// no_shadow, no_image, no_reflection, double_illuminate.
#version 3.7;
global_settings { assumed_gamma 1.0 }

camera { location <0, 2.5, -6> right x*4/3 look_at <0, 0.6, 0> angle 54 }
light_source { <-6, 9, -8>, rgb 1 }

plane { y, 0 pigment { rgb 0.5 } finish { reflection 0.5 } }
sphere { <-2.2, 0.7, 0>, 0.6 pigment { rgb <0.85, 0.35, 0.2> } no_shadow }
sphere { <-0.7, 0.7, 0>, 0.6 pigment { rgb <0.2, 0.5, 0.85> } no_image }
sphere { <0.8, 0.7, 0>, 0.6 pigment { rgb <0.3, 0.75, 0.35> } no_reflection }
disc { <2.3, 0.8, 0>, <0.4, -0.5, 1>, 0.7 pigment { rgb <0.9, 0.8, 0.3> } double_illuminate }
