// gradient with color maps, waves, frequency and phase.
#version 3.7;
global_settings { assumed_gamma 1.0 }

camera { orthographic location <0, 0, -5> right x*8 up y*6 look_at 0 }
light_source { <0, 0, -100>, rgb 1 }
#default { finish { ambient 0.2 diffuse 0.8 } }
box { <-1.25, -1.4, 0>, <1.25, 1.4, 0.1> pigment { gradient x } translate <-2.667, 1.5, 0> }
box { <-1.25, -1.4, 0>, <1.25, 1.4, 0.1> pigment { gradient <1, 1, 0> color_map { [0 rgb <0.9, 0.2, 0.1>] [0.5 rgb <1, 0.9, 0.3>] [1 rgb <0.1, 0.3, 0.7>] } } translate <0, 1.5, 0> }
box { <-1.25, -1.4, 0>, <1.25, 1.4, 0.1> pigment { gradient y triangle_wave color_map { [0.2 rgb 0] [0.2 rgb <0.3, 0.8, 0.4>] [1 rgb 1] } } translate <2.667, 1.5, 0> }
box { <-1.25, -1.4, 0>, <1.25, 1.4, 0.1> pigment { gradient x sine_wave frequency 3 phase 0.2 } translate <-2.667, -1.5, 0> }
box { <-1.25, -1.4, 0>, <1.25, 1.4, 0.1> pigment { gradient y scallop_wave frequency 2 color_map { [0 rgb <0.2, 0.1, 0.4>] [1 rgb <1, 0.7, 0.5>] } } translate <0, -1.5, 0> }
box { <-1.25, -1.4, 0>, <1.25, 1.4, 0.1> pigment { gradient x poly_wave 3 scale 2.5 translate 1.25 } translate <2.667, -1.5, 0> }
