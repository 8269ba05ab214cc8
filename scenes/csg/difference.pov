// Differences: the cut shows the subtracted solid's texture, or the parent's.
#version 3.7;
global_settings { assumed_gamma 1.0 }

camera { location <0, 2.5, -6> right x*4/3 look_at <0, 0.6, 0> angle 54 }
light_source { <-6, 9, -8>, rgb 1 }
plane { y, 0 pigment { checker rgb <0.75, 0.72, 0.65> rgb <0.35, 0.38, 0.42> } }

difference { sphere { 0, 1 } cylinder { -2*z, 2*z, 0.45 } box { 0, 2 pigment { rgb <0.2, 0.5, 0.85> } } rotate y*30 translate y pigment { rgb <0.85, 0.35, 0.2> } finish { specular 0.4 roughness 0.03 } }
difference { box { <-0.6, 0, -0.6>, <0.6, 1.2, 0.6> } box { <-0.45, 0.15, -0.9>, <0.45, 1.4, 0.45> } translate <-2.1, 0, 0> pigment { rgb <0.9, 0.75, 0.3> } }
difference { cylinder { 0, y, 0.7 } sphere { y, 0.6 } translate <2.1, 0, 0> pigment { rgb <0.3, 0.75, 0.35> } }
