// Old and new colour map entries, steps, colour words.
#version 3.7;
global_settings { assumed_gamma 1.0 }

camera { orthographic location <0, 0, -5> right x*8 up y*6 look_at 0 }
light_source { <0, 0, -100>, rgb 1 }
#default { finish { ambient 0.2 diffuse 0.8 } }
box { <-1.25, -1.4, 0>, <1.25, 1.4, 0.1> pigment { gradient x color_map { [0 0.5 color rgb 1 color rgb <1, 0, 0>] [0.5 1 color rgb <0, 0, 1> color rgb 0] } scale 2.5 translate 1.25 } translate <-2.667, 1.5, 0> }
box { <-1.25, -1.4, 0>, <1.25, 1.4, 0.1> pigment { gradient x colour_map { [0 color red 1] [0.3 color green 0.7 blue 0.2] [0.6 colour rgb <0.9, 0.8, 0.1>] [1 rgb 0.1] } scale 2.5 translate 1.25 } translate <0, 1.5, 0> }
box { <-1.25, -1.4, 0>, <1.25, 1.4, 0.1> pigment { gradient y color_map { [0.25 rgb 0.2] [0.25 rgb 0.8] [0.75 rgb 0.8] [0.75 rgb 0.2] } } translate <2.667, 1.5, 0> }
