// Balls in a row through the plane of focus. Samples: of the lens; fewer where they vary less than Variance.
#version 3.7;
#ifndef (Samples) #declare Samples = 19; #end
#ifndef (Variance) #declare Variance = 1/20000; #end
global_settings { assumed_gamma 1 }
camera {
  location <-3, 2.5, -8> look_at <0, 0.6, 0> angle 35
  aperture 0.6 focal_point <0, 0.6, 0> blur_samples Samples confidence 0.95 variance Variance
}
light_source { <5, 9, -8>, 1 }
plane { y, 0 pigment { checker rgb 0.9 rgb 0.4 } }
#for (I, -4, 6)
  sphere { <0.5*I, 0.6, 1.4*I>, 0.5 pigment { rgb <0.8, 0.5 - 0.05*I, 0.3 + 0.05*I> } finish { specular 0.6 } }
#end
