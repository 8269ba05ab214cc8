// Perturbed normals: bumps, dents, ripples, waves, wrinkles, a pattern.
#version 3.7;
global_settings { assumed_gamma 1.0 }

camera { location <0, 2.5, -6> right x*4/3 look_at <0, 0.6, 0> angle 54 }
light_source { <-6, 9, -8>, rgb 1 }
plane { y, 0 pigment { checker rgb <0.75, 0.72, 0.65> rgb <0.35, 0.38, 0.42> } }
sphere { <-1.5, 1.9, 0>, 0.6 pigment { rgb 0.8 } normal { bumps 0.6 scale 0.15 } finish { specular 0.4 } }
sphere { <0, 1.9, 0>, 0.6 pigment { rgb 0.8 } normal { dents 1.2 scale 0.15 } finish { specular 0.4 } }
sphere { <1.5, 1.9, 0>, 0.6 pigment { rgb 0.8 } normal { wrinkles 0.7 scale 0.3 } finish { specular 0.4 } }
sphere { <-1.5, 0.6, 0>, 0.6 pigment { rgb 0.8 } normal { ripples 0.5 scale 0.1 } finish { specular 0.4 } }
sphere { <0, 0.6, 0>, 0.6 pigment { rgb 0.8 } normal { waves 0.4 scale 0.1 } finish { specular 0.4 } }
sphere { <1.5, 0.6, 0>, 0.6 pigment { rgb 0.8 } normal { gradient y 0.6 sine_wave scale 0.2 } finish { specular 0.4 } }
