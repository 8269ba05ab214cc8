// Light bent by glass: a ball, a tinted box turned on its corner, a prism that splits colours; the block to the right
// does not collect.
// tolerance: 0.01
#version 3.7;
global_settings {
  assumed_gamma 1
  max_trace_level 8
  photons { count 150000 gather 40, 150 }
}
camera { location <0, 5, -9> look_at <0, 0.3, 0> angle 50 }
light_source { <-6, 10, -2> rgb 1.2 photons { refraction on } }
plane { y, 0 pigment { rgb <0.85, 0.8, 0.7> } finish { ambient 0.05 diffuse 0.8 } }
#declare Clear = finish { ambient 0 diffuse 0 specular 0.5 roughness 0.005 }
sphere {
  <-1.8, 1.1, 0>, 1
  pigment { rgbf 1 } finish { Clear } interior { ior 1.5 }
  photons { target }
}
box {
  -0.7, 0.7
  rotate <35, 45, 0> translate <0.9, 1.5, 1.6>
  pigment { rgbf <0.6, 0.9, 1, 0.9> } finish { Clear }
  interior { ior 1.33 fade_distance 1 fade_power 1 fade_color <0.3, 0.7, 0.9> }
  photons { target }
}
prism {
  -1, 1, 4, <-0.7, 0>, <0.7, 0>, <0, 1.1>, <-0.7, 0>
  rotate -90*x translate <0.8, 0.5, -1.6>
  pigment { rgbf 1 } finish { Clear } interior { ior 1.5 dispersion 1.1 dispersion_samples 12 }
  photons { target }
}
box {
  <2.3, 0, -1>, <3.6, 0.8, 0.6>
  pigment { rgb <0.7, 0.4, 0.3> } finish { ambient 0.05 }
  photons { collect off }
}
