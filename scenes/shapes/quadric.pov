// Quadrics: a hyperboloid and a paraboloid cut by boxes, and a turned paraboloid, clipped.
#version 3.7;
global_settings { assumed_gamma 1.0 }

camera { location <0, 2.5, -6> right x*4/3 look_at <0, 0.6, 0> angle 54 }
light_source { <-6, 9, -8>, rgb 1 }
plane { y, 0 pigment { checker rgb <0.75, 0.72, 0.65> rgb <0.35, 0.38, 0.42> } }

intersection { quadric { <1, -1, 1>, <0, 0, 0>, <0, 0, 0>, -0.2 } box { <-2, -1, -2>, <2, 1, 2> } translate y pigment { rgb <0.85, 0.35, 0.2> } finish { specular 0.4 roughness 0.03 } }
intersection { quadric { <1, 0, 1>, 0, <0, 1, 0>, -1 } box { <-2, 0, -2>, <2, 1, 2> } translate <2.2, 0, 0.5> pigment { rgb <0.2, 0.5, 0.85> } }
quadric { <1, 0, 1>, 0, <0, -1, 0>, 0 clipped_by { box { <-2, 0, -2>, <2, 1, 2> } } scale 0.8 rotate <-50, 20, 0> translate <-2.2, 0.6, -0.5> pigment { rgb <0.4, 0.7, 0.3> } }
