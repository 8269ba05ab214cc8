// Eggs: both ways up, stretched, with surface coordinates, and one that is only its upper sphere.
#version 3.7;
global_settings { assumed_gamma 1.0 }

camera { location <0, 3, -7> right x*4/3 look_at <0, 1, 0> angle 50 }
light_source { <-6, 9, -8>, rgb 1 }
plane { y, 0 pigment { checker rgb <0.75, 0.72, 0.65> rgb <0.35, 0.38, 0.42> } }

ovus { 1, 0.6 translate <-2, 1, 0.5> pigment { rgb <0.85, 0.35, 0.2> } finish { specular 0.4 } }
ovus { 0.6, 0.8 rotate z*-40 translate <0, 0.9, 0.6> pigment { rgb <0.2, 0.5, 0.85> } }
ovus { 0.5, 0.2 scale <1, 1.5, 0.7> rotate <30, 20, 0> translate <2, 0.8, 0.2> pigment { rgb <0.3, 0.75, 0.35> } }
ovus { 0.4, 0.3 uv_mapping pigment { checker rgb <0.9, 0.8, 0.3> rgb <0.5, 0.3, 0.1> scale 0.1 } rotate y*40 translate <-0.7, 0.4, -1.8> }
ovus { 0.2, 0.4 translate <0.9, 0.2, -1.8> pigment { rgb <0.6, 0.4, 0.8> } }
