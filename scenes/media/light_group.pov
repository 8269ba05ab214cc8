// Media scatter the light of those lights that shine where a ray's way ends: in a light_group, and outside of it.
#version 3.7;
global_settings { assumed_gamma 1.0 }
camera { location <0, 1, -6> look_at <0, 0.5, 0> angle 50 }
light_source { <6, 8, -8>, rgb <0.6, 0.2, 0.2> }
plane { y, -1 pigment { checker rgb 0.7 rgb 0.3 } }
#declare Fog = interior { media { scattering { 1, rgb 0.6 extinction 0.5 } method 3 samples 30 } }
light_group {
  light_source { <-4, 4, -4>, rgb <0.2, 1, 0.3> }
  sphere { <-1.2, 0.6, 0>, 1.1 hollow pigment { rgbt 1 } interior { Fog } }
  box { <-1.6, -1, 2>, <-0.6, 0.5, 2.5> pigment { rgb 1 } }
  global_lights off
}
sphere { <1.2, 0.6, 0>, 1.1 hollow pigment { rgbt 1 } interior { Fog } }
