// Planes: the distance is along the unit normal; rotated and scaled planes; inverse.
#version 3.7;
global_settings { assumed_gamma 1.0 }

camera { location <0, 2.5, -6> right x*4/3 look_at <0, 0.6, 0> angle 54 }
light_source { <-6, 9, -8>, rgb 1 }

plane { <0, 3, 0>, 0 pigment { checker rgb 0.8 rgb 0.3 } }
plane { z, 5 rotate y*-25 pigment { checker rgb <0.8, 0.6, 0.3> rgb <0.5, 0.3, 0.2> scale 2 } }
plane { -x, 2 scale 2 rotate y*10 inverse pigment { rgb <0.3, 0.5, 0.7> } }
