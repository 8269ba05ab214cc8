// A bubble in a ball: interiors inside interiors, and a common one.
#version 3.7;
global_settings { assumed_gamma 1.0 max_trace_level 10 }

camera { location <0, 2.5, -6> right x*4/3 look_at <0, 0.6, 0> angle 54 }
light_source { <-6, 9, -8>, rgb 1 }
plane { y, 0 pigment { checker rgb <0.75, 0.72, 0.65> rgb <0.35, 0.38, 0.42> } }

sphere { <-1.2, 1, 0>, 0.9 pigment { rgbt <0.9, 0.95, 1, 0.9> } interior { ior 1.5 } }
sphere { <-1.2, 1, 0>, 0.5 pigment { rgbt <1, 0.9, 0.9, 0.9> } interior { ior 1.0 } }
union { sphere { <-0.4, 0, 0>, 0.6 } sphere { <0.4, 0, 0>, 0.6 } translate <1.4, 0.8, 0> pigment { rgbf <0.8, 1, 0.8, 0.9> } interior { ior 1.2 } }
