// Textures whose details shrink below a pixel.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 1.5, -6> look_at <0, 0.8, 0> angle 50 }
light_source { <-5, 9, -8>, 1 }
plane { y, 0 pigment { checker rgb 0.95 rgb <0.1, 0.1, 0.3> scale 0.25 } }
sphere { <-1.2, 1, 0>, 1 pigment { granite color_map { [0 rgb 0.1] [1 rgb <1, 0.9, 0.7>] } scale 0.15 } }
sphere { <1.2, 1, 0>, 1 pigment { gradient y + x color_map { [0.5 rgb 1] [0.5 rgb <0.6, 0.1, 0.1>] } scale 0.04 } }
