// Transformations: order, matrix, inverse, declared transforms.
#version 3.7;
global_settings { assumed_gamma 1.0 }

camera { location <0, 2.5, -6> right x*4/3 look_at <0, 0.6, 0> angle 54 }
light_source { <-6, 9, -8>, rgb 1 }
plane { y, 0 pigment { checker rgb <0.75, 0.72, 0.65> rgb <0.35, 0.38, 0.42> } }

#declare T = transform { rotate z*30 translate <1.2, 0.5, 0> }
box { -0.4, 0.4 transform { T } pigment { rgb <0.85, 0.35, 0.2> } }
box { -0.4, 0.4 translate <-1.2, 0.9, 0> rotate y*20 pigment { rgb <0.2, 0.5, 0.85> } }
box { -0.4, 0.4 matrix <1, 0.3, 0, 0, 1, 0, 0.4, 0, 1, 0, 1.9, 0> pigment { rgb <0.3, 0.75, 0.35> } }
sphere { <1.2, 0.5, 0>, 0.3 transform { T inverse } translate <0, 0.5, -0.8> pigment { rgb <0.9, 0.8, 0.3> } }
