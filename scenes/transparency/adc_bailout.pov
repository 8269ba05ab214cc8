// adc_bailout cuts weak rays.
#version 3.7;
global_settings { assumed_gamma 1.0 adc_bailout 0.2 }

camera { location <0, 2.5, -6> right x*4/3 look_at <0, 0.6, 0> angle 54 }
light_source { <-6, 9, -8>, rgb 1 }
plane { y, 0 pigment { checker rgb <0.75, 0.72, 0.65> rgb <0.35, 0.38, 0.42> } }
background { rgb <0.6, 0.7, 0.9> }
sphere { <-1.2, 0.9, 0>, 0.8 pigment { rgbt <0.9, 0.9, 0.9, 0.5> } finish { reflection 0.3 } interior { ior 1.3 } }
sphere { <1.2, 0.9, 0>, 0.8 pigment { rgb 0.2 } finish { reflection 0.4 } }
