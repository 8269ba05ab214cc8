// Reflection: constant, by angle, with falloff, metallic.
#version 3.7;
global_settings { assumed_gamma 1.0 }

camera { location <0, 2.5, -6> right x*4/3 look_at <0, 0.6, 0> angle 54 }
light_source { <-6, 9, -8>, rgb 1 }
plane { y, 0 pigment { checker rgb <0.75, 0.72, 0.65> rgb <0.35, 0.38, 0.42> } }
background { rgb <0.5, 0.6, 0.8> }
sphere { <-2.3, 0.75, 0>, 0.62 pigment { rgb <0.75, 0.5, 0.3> } finish { reflection 0.4 } }
sphere { <-0.767, 0.75, 0>, 0.62 pigment { rgb <0.75, 0.5, 0.3> } finish { reflection { 0.05, 0.9 } } }
sphere { <0.767, 0.75, 0>, 0.62 pigment { rgb <0.75, 0.5, 0.3> } finish { reflection { 0, 1 falloff 3 } } }
sphere { <2.3, 0.75, 0>, 0.62 pigment { rgb <0.75, 0.5, 0.3> } finish { reflection { 0.6 metallic } } }
