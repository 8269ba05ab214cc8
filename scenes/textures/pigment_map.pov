// Pigments in pigments: pigment_map, nested patterns, average.
#version 3.7;
global_settings { assumed_gamma 1.0 }

camera { orthographic location <0, 0, -5> right x*8 up y*6 look_at 0 }
light_source { <0, 0, -100>, rgb 1 }
#default { finish { ambient 0.2 diffuse 0.8 } }
box { <-1.25, -1.4, 0>, <1.25, 1.4, 0.1> pigment { gradient x pigment_map { [0.3 rgb <0.9, 0.3, 0.2>] [0.6 checker rgb 1 rgb 0 scale 0.2] } scale 2.5 translate 1.25 } translate <-2.667, 1.5, 0> }
box { <-1.25, -1.4, 0>, <1.25, 1.4, 0.1> pigment { average pigment_map { [1 gradient x] [2 gradient y color_map { [0 rgb <1, 0, 0>] [1 rgb <0, 0, 1>] }] } } translate <0, 1.5, 0> }
box { <-1.25, -1.4, 0>, <1.25, 1.4, 0.1> pigment { bozo pigment_map { [0.4 granite scale 0.3] [0.6 marble turbulence 0.5 scale 0.2] } scale 0.6 } translate <2.667, 1.5, 0> }
