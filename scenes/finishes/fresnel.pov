// Fresnel reflection by the index of refraction.
#version 3.7;
global_settings { assumed_gamma 1.0 }

camera { location <0, 2.5, -6> right x*4/3 look_at <0, 0.6, 0> angle 54 }
light_source { <-6, 9, -8>, rgb 1 }
plane { y, 0 pigment { checker rgb <0.75, 0.72, 0.65> rgb <0.35, 0.38, 0.42> } }
background { rgb <0.5, 0.6, 0.8> }
sphere { <-1.5, 0.8, 0>, 0.7 pigment { rgb 0.05 } finish { reflection { 1 fresnel } } interior { ior 1.3 } }
sphere { <0, 0.8, 0>, 0.7 pigment { rgb 0.05 } finish { reflection { 1 fresnel } } interior { ior 2.4 } }
sphere { <1.5, 0.8, 0>, 0.7 pigment { rgbt <0.9, 1, 0.95, 0.8> } finish { reflection { 0.1, 1 fresnel } conserve_energy } interior { ior 1.5 } }
