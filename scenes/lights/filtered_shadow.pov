// Coloured shadows of filtering and transmitting surfaces.
#version 3.7;
global_settings { assumed_gamma 1.0 }

camera { location <0, 2.5, -6> right x*4/3 look_at <0, 0.6, 0> angle 54 }
light_source { <-6, 9, -8>, rgb 1 }

plane { y, 0 pigment { rgb 0.85 } }
sphere { <-1.6, 0.9, 0>, 0.8 pigment { rgbf <1, 0.4, 0.3, 0.8> } }
box { <-0.4, 0.1, -0.4>, <0.4, 1.3, 0.4> rotate y*20 translate x*0.3 pigment { rgbt <0.3, 0.9, 0.4, 0.6> } }
disc { <2, 1, 0>, <0.3, 1, 0.2>, 0.7 pigment { rgbft <0.3, 0.4, 1, 0.5, 0.3> } }
