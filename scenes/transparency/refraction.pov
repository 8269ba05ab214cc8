// Glass spheres and a prism: index of refraction.
#version 3.7;
global_settings { assumed_gamma 1.0 }

camera { location <0, 2.5, -6> right x*4/3 look_at <0, 0.6, 0> angle 54 }
light_source { <-6, 9, -8>, rgb 1 }
plane { y, 0 pigment { checker rgb <0.75, 0.72, 0.65> rgb <0.35, 0.38, 0.42> } }

sphere { <-1.5, 0.9, 0>, 0.8 pigment { rgbt <1, 1, 1, 0.95> } finish { specular 0.8 roughness 0.01 } interior { ior 1.5 } }
sphere { <0.2, 0.7, -0.8>, 0.5 pigment { rgbf <0.6, 1, 0.8, 0.95> } interior { ior 1.1 } }
box { <-0.5, 0.02, -0.5>, <0.5, 1.2, 0.5> rotate y*40 translate x*1.6 pigment { rgbf <1, 0.8, 0.6, 0.95> } interior { ior 2.4 } }
