// Sampling method 2, with jitter.
// options: +A0.1 +AM2 +R3
#version 3.7;
global_settings { assumed_gamma 1.0 }

camera { location <0, 2.5, -6> right x*4/3 look_at <0, 0.6, 0> angle 54 }
light_source { <-6, 9, -8>, rgb 1 }
plane { y, 0 pigment { checker rgb <0.75, 0.72, 0.65> rgb <0.35, 0.38, 0.42> } }
sphere { <-1.2, 1, 0>, 0.9 pigment { rgb <0.85, 0.35, 0.2> } finish { reflection 0.2 } }
box { <0.4, 0, -0.6>, <1.6, 1.6, 0.6> rotate y*15 pigment { rgb <0.2, 0.5, 0.85> } }
