// A pattern of textures: both are shaded and mixed.
#version 3.7;
global_settings { assumed_gamma 1.0 }

camera { location <0, 2.5, -6> right x*4/3 look_at <0, 0.6, 0> angle 54 }
light_source { <-6, 9, -8>, rgb 1 }
plane { y, 0 pigment { checker rgb <0.75, 0.72, 0.65> rgb <0.35, 0.38, 0.42> } }

sphere { <-1.3, 1, 0>, 0.9 texture { gradient y texture_map { [0.3 pigment { rgb <0.2, 0.4, 0.8> } finish { reflection 0.4 }] [0.7 pigment { rgb <0.9, 0.7, 0.3> } finish { phong 0.8 }] } } }
box { -0.7, 0.7 rotate y*30 translate <1.4, 0.7, 0> texture { checker texture { pigment { rgb 0.9 } } texture { pigment { rgb <0.6, 0.1, 0.1> } finish { specular 0.6 } } scale 0.35 } }
