// filter tints what is seen through, transmit does not.
#version 3.7;
global_settings { assumed_gamma 1.0 }

camera { location <0, 2.5, -6> right x*4/3 look_at <0, 0.6, 0> angle 54 }
light_source { <-6, 9, -8>, rgb 1 }
plane { y, 0 pigment { checker rgb <0.75, 0.72, 0.65> rgb <0.35, 0.38, 0.42> } }

sphere { <-2, 0.8, 0>, 0.7 pigment { rgbf <0.9, 0.5, 0.3, 0.9> } }
sphere { <-0.6, 0.8, 0>, 0.7 pigment { rgbt <0.9, 0.5, 0.3, 0.7> } }
sphere { <0.8, 0.8, 0>, 0.7 pigment { rgbft <0.3, 0.6, 0.9, 0.5, 0.4> } }
disc { <2.2, 0.9, 0>, <-0.4, 0.2, -1>, 0.7 pigment { rgb <0.3, 0.8, 0.4> transmit 0.5 } }
