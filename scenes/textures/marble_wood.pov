// marble, wood, onion, leopard, radial, spherical with turbulence.
#version 3.7;
global_settings { assumed_gamma 1.0 }

camera { orthographic location <0, 0, -5> right x*8 up y*6 look_at 0 }
light_source { <0, 0, -100>, rgb 1 }
#default { finish { ambient 0.2 diffuse 0.8 } }
box { <-1.25, -1.4, 0>, <1.25, 1.4, 0.1> pigment { marble turbulence 0.6 scale 0.6 } translate <-2.667, 1.5, 0> }
box { <-1.25, -1.4, 0>, <1.25, 1.4, 0.1> pigment { wood turbulence 0.08 scale 0.4 rotate x*80 } translate <0, 1.5, 0> }
box { <-1.25, -1.4, 0>, <1.25, 1.4, 0.1> pigment { onion scale 0.4 } translate <2.667, 1.5, 0> }
box { <-1.25, -1.4, 0>, <1.25, 1.4, 0.1> pigment { leopard scale 0.12 } translate <-2.667, -1.5, 0> }
box { <-1.25, -1.4, 0>, <1.25, 1.4, 0.1> pigment { radial frequency 8 rotate x*90 } translate <0, -1.5, 0> }
box { <-1.25, -1.4, 0>, <1.25, 1.4, 0.1> pigment { spherical turbulence 0.3 octaves 3 scale 1.4 } translate <2.667, -1.5, 0> }
