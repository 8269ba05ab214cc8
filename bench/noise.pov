// A wall of bars, a beam, a ball and a slab in the light of an area light of N x N places; adaptive if AD >= 0.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { orthographic location 10*y look_at 0 right 8*x up 6*z }
plane { y, 0 pigment { rgb 1 } finish { ambient 0 diffuse 1 } }
light_source {
  8*y rgb 0.9 area_light 3*x, 3*z, N, N jitter
  #if (AD >= 0) adaptive AD #end
}
union {
  sphere { <-2, 2.5, 1>, 0.7 }
  box { <0.5, 2.5, -3>, <0.6, 2.6, 3> }
  #for (i, 0, 9) box { <1 + 0.3*i, 3, -2>, <1.15 + 0.3*i, 3.05, -0.5> } #end
  box { <-3, 2, -2>, <-1, 2.1, -1> }
  no_image pigment { rgb 1 }
}
