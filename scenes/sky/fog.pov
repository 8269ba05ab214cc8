// Constant and ground fog.
#version 3.7;
global_settings { assumed_gamma 1.0 }

camera { location <0, 2.5, -6> right x*4/3 look_at <0, 0.6, 0> angle 54 }
light_source { <-6, 9, -8>, rgb 1 }
plane { y, 0 pigment { checker rgb <0.75, 0.72, 0.65> rgb <0.35, 0.38, 0.42> } }

fog { distance 30 rgb <0.7, 0.75, 0.8> }
fog { fog_type 2 distance 9 rgb <0.9, 0.9, 0.95> fog_offset 0.2 fog_alt 0.3 }
sphere { <-1.5, 1, 0>, 0.8 pigment { rgb <0.85, 0.35, 0.2> } }
box { <0, 0, 3>, <2, 2.5, 5> pigment { rgb <0.2, 0.5, 0.3> } }
