// assumed_gamma 2.2.
#version 3.7;
global_settings { assumed_gamma 2.2 }

camera { location <0, 2.5, -6> right x*4/3 look_at <0, 0.6, 0> angle 54 }
light_source { <-6, 9, -8>, rgb 1 }
plane { y, 0 pigment { checker rgb <0.75, 0.72, 0.65> rgb <0.35, 0.38, 0.42> } }
sphere { <0, 1, 0>, 1 pigment { gradient y } }
