// Wires thinner than a pixel.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 2, -7> look_at <0, 1.2, 0> angle 45 }
light_source { <-5, 9, -8>, 1 }
background { rgb <0.6, 0.75, 0.95> }
plane { y, 0 pigment { rgb <0.6, 0.6, 0.5> } }
union {
  #for (I, -30, 30)
    cylinder { <0.1*I, 0, 0>, <0.1*I, 2.6, 0.02*I>, 0.008 }
    cylinder { <-3, 1.3 + 0.04*I, 0.4>, <3, 1.3 - 0.03*I, 0.4>, 0.006 }
  #end
  pigment { rgb <0.25, 0.15, 0.1> } finish { specular 0.5 }
}
