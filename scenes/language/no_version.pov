// No #version and no assumed_gamma, as most old scenes: numbers go to the file unchanged.

camera { location <0, 2.5, -6> right x*4/3 look_at <0, 0.6, 0> angle 54 }
light_source { <-6, 9, -8>, rgb 1 }
plane { y, 0 pigment { checker rgb <0.75, 0.72, 0.65> rgb <0.35, 0.38, 0.42> } }

sphere { <-1, 1, 0>, 0.9 pigment { color red 0.8 green 0.4 blue 0.2 } finish { phong 0.5 } }
sphere { <1.1, 0.8, 0>, 0.7 pigment { color rgbf <0.3, 0.6, 0.9, 0.5> } }
