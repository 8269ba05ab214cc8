// Inside a block of glass rays are reflected totally.
#version 3.7;
global_settings { assumed_gamma 1.0 max_trace_level 12 }

camera { location <0, 2.5, -6> right x*4/3 look_at <0, 0.6, 0> angle 54 }
light_source { <-6, 9, -8>, rgb 1 }

plane { y, 0 pigment { checker rgb 0.9 rgb <0.2, 0.3, 0.6> scale 0.5 } }
box { <-1.5, 0.01, -1>, <1.5, 1.2, 1> rotate y*20 pigment { rgbt <1, 1, 1, 0.9> } interior { ior 1.8 } }
sphere { <0, 0.4, 2>, 0.6 pigment { rgb <0.9, 0.3, 0.2> } }
