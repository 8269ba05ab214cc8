// A lens gathers a beam in smoke: photons that are left in media along their way.
// tolerance: 0.03
#version 3.7;
global_settings {
  assumed_gamma 1
  photons { spacing 0.03 gather 30, 100 media 60 radius 0.15, 1, 0.2, 1 }
}
camera { location <0, 1.5, -9> look_at <0, 0.2, 0> angle 48 }
light_source {
  <0, 12, 0> rgb <1, 0.9, 0.7>
  spotlight point_at 0 radius 9 falloff 11
  photons { refraction on }
}
plane { y, -2.2 pigment { rgb 0.6 } finish { ambient 0.02 } }
plane { -z, -6 pigment { rgb 0.15 } finish { ambient 0.02 } photons { collect off } }
sphere {
  0, 1
  scale <1.2, 0.5, 1.2> translate 2*y
  pigment { rgbf 1 } finish { ambient 0 diffuse 0 specular 0.4 } interior { ior 1.5 }
  photons { target }
}
box {
  <-3, -2.1, -2>, <3, 1.2, 2>
  hollow
  pigment { rgbt 1 } finish { ambient 0 diffuse 0 }
  interior { media { scattering { 1, 0.12 extinction 0.6 } } }
  photons { collect off }
}
