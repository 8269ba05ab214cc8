// Focal blur: sharp where the focal point is, samples taken until they agree.
#version 3.7;
global_settings { assumed_gamma 1.0 }
camera {
  location <0, 1.5, -6>
  look_at <0, 0.6, 0>
  right x*4/3
  up y
  angle 45
  aperture 0.6
  blur_samples 30
  focal_point <0, 0.5, 0>
  variance 1/10000
  confidence 0.95
}
light_source { <4, 8, -6> color rgb 1 }
plane { y, 0 pigment { checker color rgb 0.9, color rgb 0.3 } }
#declare K = -2;
#while (K <= 4)
  sphere { <0.7 * K - 0.5, 0.5, 2 * K>, 0.5
    pigment { color rgb <0.9, 0.3 + 0.1 * K, 0.2> }
    finish { specular 0.5 roughness 0.02 }
  }
  cylinder { <-1.5, 0, 1.5 * K>, <-1.5, 1.5, 1.5 * K>, 0.15 pigment { color rgb <0.2, 0.4, 0.9> } }
  #declare K = K + 1;
#end
