// Light gathered by a glass ball and a ring. Count: of photons.
#version 3.7;
#ifndef (Count) #declare Count = 20000; #end
global_settings { assumed_gamma 1 max_trace_level 8 photons { count Count } }
camera { location <0, 5, -6> look_at <0, 0, 0> angle 40 }
light_source { <5, 6, 2>, 1 photons { refraction on reflection on } }
plane { y, 0 pigment { rgb 0.6 } finish { ambient 0 } }
sphere { <-0.9, 0.8, 0>, 0.7 pigment { rgbf 1 } finish { diffuse 0 } interior { ior 1.5 }
  photons { target refraction on collect off }
}
difference {
  cylinder { 0, 0.5*y, 0.9 } cylinder { -y, y, 0.8 }
  translate <1, 0, -0.5> pigment { rgb <0.9, 0.7, 0.4> } finish { diffuse 0.1 reflection 0.8 }
  photons { target reflection on }
}
