// Two facing mirrors: max_trace_level ends the row of pictures.
#version 3.7;
global_settings { assumed_gamma 1.0 max_trace_level 8 }

camera { location <0, 2.5, -6> right x*4/3 look_at <0, 0.6, 0> angle 54 }
light_source { <-6, 9, -8>, rgb 1 }
plane { y, 0 pigment { checker rgb <0.75, 0.72, 0.65> rgb <0.35, 0.38, 0.42> } }

box { <-3, 0, 1.5>, <3, 3, 1.6> pigment { rgb 0.1 } finish { reflection 0.9 } }
box { <-3, 0, -7.1>, <3, 3, -7> pigment { rgb 0.1 } finish { reflection 0.9 } }
sphere { <0, 0.8, 0>, 0.6 pigment { rgb <0.85, 0.35, 0.2> } }
