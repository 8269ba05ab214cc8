// Glass balls over a patterned floor.
#version 3.7;
global_settings { assumed_gamma 1 max_trace_level 10 }
camera { location <0, 3, -8> look_at <0, 0.9, 0> angle 42 }
light_source { <-6, 9, -7>, 1 }
sky_sphere { pigment { gradient y color_map { [0 rgb <0.8, 0.85, 0.9>] [1 rgb <0.2, 0.4, 0.8>] } } }
plane { y, 0 pigment { checker rgb 0.9 rgb <0.2, 0.3, 0.4> } }
#for (I, -2, 2)
  sphere { <1.5*I, 0.8, 0.7*abs(I)>, 0.8
    pigment { rgbf <0.95, 0.98, 0.95, 1> }
    finish { diffuse 0 reflection { 0, 1 fresnel } conserve_energy specular 0.8 roughness 0.002 }
    interior { ior 1.5 }
  }
#end
