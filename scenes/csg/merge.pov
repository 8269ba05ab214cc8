// A merge removes inner surfaces: union and merge of the same glass spheres.
#version 3.7;
global_settings { assumed_gamma 1.0 }

camera { location <0, 2.5, -6> right x*4/3 look_at <0, 0.6, 0> angle 54 }
light_source { <-6, 9, -8>, rgb 1 }
plane { y, 0 pigment { checker rgb <0.75, 0.72, 0.65> rgb <0.35, 0.38, 0.42> } }

#declare Glass = texture { pigment { rgbt <0.7, 0.9, 0.8, 0.7> } finish { specular 0.5 } }
union { sphere { <-0.4, 0, 0>, 0.7 } sphere { <0.4, 0, 0>, 0.7 } texture { Glass } translate <-1.4, 0.8, 0> }
merge { sphere { <-0.4, 0, 0>, 0.7 } sphere { <0.4, 0, 0>, 0.7 } texture { Glass } translate <1.4, 0.8, 0> }
