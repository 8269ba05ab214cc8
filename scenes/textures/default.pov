// #default changes what comes later; the default in force at the end of the statement counts.
#version 3.7;
global_settings { assumed_gamma 1.0 }

camera { location <0, 2.5, -6> right x*4/3 look_at <0, 0.6, 0> angle 54 }
light_source { <-6, 9, -8>, rgb 1 }

#default { pigment { rgb <0.2, 0.5, 0.8> } finish { ambient 0.2 } }
plane { y, 0 }
#default { pigment { checker rgb 0.9 rgb <0.7, 0.3, 0.2> scale 0.5 } }
sphere { <-1.2, 0.9, 0>, 0.8 }
union { box { <0.4, 0, -0.6>, <1.6, 1.2, 0.6> } #default { texture { pigment { rgb <0.3, 0.7, 0.3> } finish { phong 0.7 } } } }
