// Blinn highlights: roughness, albedo, metallic.
#version 3.7;
global_settings { assumed_gamma 1.0 }

camera { location <0, 2.5, -6> right x*4/3 look_at <0, 0.6, 0> angle 54 }
light_source { <-6, 9, -8>, rgb 1 }
plane { y, 0 pigment { checker rgb <0.75, 0.72, 0.65> rgb <0.35, 0.38, 0.42> } }
sphere { <-2.3, 0.75, 0>, 0.62 pigment { rgb <0.75, 0.5, 0.3> } finish { specular 0.5 } }
sphere { <-0.767, 0.75, 0>, 0.62 pigment { rgb <0.75, 0.5, 0.3> } finish { specular 0.9 roughness 0.2 } }
sphere { <0.767, 0.75, 0>, 0.62 pigment { rgb <0.75, 0.5, 0.3> } finish { specular albedo 0.2 roughness 0.02 } }
sphere { <2.3, 0.75, 0>, 0.62 pigment { rgb <0.75, 0.5, 0.3> } finish { specular 0.9 roughness 0.05 metallic } }
