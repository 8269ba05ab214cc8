// Layers with filter and transmit.
#version 3.7;
global_settings { assumed_gamma 1.0 }

camera { location <0, 2.5, -6> right x*4/3 look_at <0, 0.6, 0> angle 54 }
light_source { <-6, 9, -8>, rgb 1 }
plane { y, 0 pigment { checker rgb <0.75, 0.72, 0.65> rgb <0.35, 0.38, 0.42> } }

sphere { <-1.3, 1, 0>, 0.9
  texture { pigment { checker rgb <0.9, 0.8, 0.6> rgb <0.5, 0.2, 0.1> scale 0.4 } }
  texture { pigment { gradient y color_map { [0.4 rgbt 1] [0.6 rgbt <0.1, 0.3, 0.9, 0.2>] } } finish { phong 0.6 } }
}
box { -0.7, 0.7 rotate y*30 translate <1.4, 0.7, 0>
  texture { pigment { rgb <0.3, 0.8, 0.4> } }
  texture { pigment { gradient x color_map { [0.5 rgbf <1, 0.6, 0.2, 0.7>] [0.5 rgbt 1] } scale 0.3 } }
}
