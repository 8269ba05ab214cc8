// The same layers in a scene of version 3.6: another opacity.
#version 3.6;
global_settings { assumed_gamma 1.0 }

camera { location <0, 2.5, -6> right x*4/3 look_at <0, 0.6, 0> angle 54 }
light_source { <-6, 9, -8>, rgb 1 }
plane { y, 0 pigment { checker rgb <0.75, 0.72, 0.65> rgb <0.35, 0.38, 0.42> } }

sphere { <-1.3, 1, 0>, 0.9
  texture { pigment { rgb <0.9, 0.8, 0.6> } }
  texture { pigment { rgbf <0.2, 0.5, 0.9, 0.6> } finish { phong 0.6 } }
}
sphere { <1.3, 1, 0>, 0.9 pigment { rgbf <0.9, 0.5, 0.2, 0.6> } }
