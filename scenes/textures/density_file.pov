// density_file: no interpolation, linear, cubic; shifted, with turbulence and a wave, as a normal.
#version 3.7;
global_settings { assumed_gamma 1.0 }

camera { orthographic location <0, 0, -5> right x*8 up y*6 look_at 0 }
light_source { <-30, 40, -100>, rgb 1 }
#default { finish { ambient 0.2 diffuse 0.8 } }
#declare Knot = pigment { density_file df3 "knot.df3" color_map { [0 rgb <0.05, 0.1, 0.3>] [0.5 rgb <0.8, 0.3, 0.1>] [1 rgb <1, 0.95, 0.7>] } }
#declare Place = transform { translate <-0.5, -0.5, 0> scale 2.5 }
object { box { <-1.25, -1.25, 0.75>, <1.25, 1.25, 0.8> } pigment { Knot transform Place } translate <-2.667, 1.51, 0> }
object { box { <-1.25, -1.25, 0.75>, <1.25, 1.25, 0.8> } pigment { Knot interpolate 1 transform Place } translate <0, 1.51, 0> }
object { box { <-1.25, -1.25, 0.75>, <1.25, 1.25, 0.8> } pigment { Knot interpolate 2 transform Place } translate <2.667, 1.51, 0> }
object { box { <-1.25, -1.25, 0.75>, <1.25, 1.25, 0.8> } pigment { Knot interpolate 1 scale 0.6 translate 0.2 transform Place } translate <-2.667, -1.49, 0> }
object { box { <-1.25, -1.25, 0.75>, <1.25, 1.25, 0.8> } pigment { Knot interpolate 1 turbulence 0.1 frequency 3 triangle_wave transform Place } translate <0, -1.49, 0> }
object { box { <-1.25, -1.25, 0.75>, <1.25, 1.25, 0.8> } pigment { rgb <0.7, 0.8, 0.6> } normal { density_file df3 "knot.df3" interpolate 2 bump_size 1.5 transform Place } translate <2.667, -1.49, 0> }
