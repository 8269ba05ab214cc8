// Light thrown by mirrors: a ring with its cusp, a faceted ball under an area light, and a pane that photons pass
// on their way.
// tolerance: 0.01
#version 3.7;
global_settings {
  assumed_gamma 1
  photons { spacing 0.02 gather 40, 150 }
}
camera { location <0, 7, -8> look_at <0, 0, 0.2> angle 42 }
light_source {
  <8, 7, 3> rgb <1, 0.9, 0.7>
  parallel point_at 0
  photons { reflection on refraction off }
}
light_source {
  <-5, 6, -3> rgb 0.5
  area_light x, z, 3, 3 adaptive 1
  photons { reflection on area_light }
}
plane { y, 0 pigment { rgb 0.8 } finish { ambient 0.05 diffuse 0.8 } }
#declare Mirror = finish { ambient 0 diffuse 0.1 reflection { 0.8 metallic } }
difference {
  cylinder { 0, 0.7*y, 1.5 }
  cylinder { -y, 2*y, 1.4 }
  translate <1.2, 0, 0>
  pigment { rgb <1, 0.8, 0.4> } finish { Mirror }
  photons { target }
}
intersection {
  #local I = 0;
  #while (I < 12)
    plane { y, 0.8 rotate x*(25 + 47*I) rotate y*137*I }
    #local I = I + 1;
  #end
  sphere { 0, 1 }
  translate <-1.7, 1, -0.3>
  pigment { rgb <0.8, 0.9, 1> } finish { Mirror }
  photons { target 0.7 }
}
disc {
  <1.2, 3, 1.5>, y, 1
  pigment { rgbf <1, 0.5, 0.4, 0.9> } finish { ambient 0 diffuse 0.1 }
  photons { pass_through }
}
