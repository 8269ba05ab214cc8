// Light through slits into smoke. Samples: of each ray through it.
#version 3.7;
#ifndef (Samples) #declare Samples = 10; #end
global_settings { assumed_gamma 1 }
camera { location <0, 1.5, -7> look_at <0, 1.2, 0> angle 45 }
light_source { <-4, 7, 3>, 2 }
plane { y, 0 pigment { rgb 0.7 } }
#for (I, -3, 3)
  box { <I - 0.35, 3, -2>, <I + 0.35, 3.1, 2> pigment { rgb 0.5 } }
#end
box { <-4, 0.01, -2>, <4, 2.9, 2> hollow pigment { rgbt 1 }
  interior { media { scattering { 1, 0.15 extinction 1 } method 3 intervals 1 samples Samples
    density { bozo turbulence 0.5 color_map { [0.2 rgb 0.2] [0.8 rgb 1] } } } }
}
