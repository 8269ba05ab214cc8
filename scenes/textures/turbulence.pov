// Turbulence: amount, octaves, omega, lambda; as a warp; before and after transforms.
#version 3.7;
global_settings { assumed_gamma 1.0 }

camera { orthographic location <0, 0, -5> right x*8 up y*6 look_at 0 }
light_source { <0, 0, -100>, rgb 1 }
#default { finish { ambient 0.2 diffuse 0.8 } }
box { <-1.25, -1.4, 0>, <1.25, 1.4, 0.1> pigment { gradient x turbulence 0.4 } translate <-2.667, 1.5, 0> }
box { <-1.25, -1.4, 0>, <1.25, 1.4, 0.1> pigment { gradient x turbulence <0.2, 0.8, 0> octaves 3 } translate <0, 1.5, 0> }
box { <-1.25, -1.4, 0>, <1.25, 1.4, 0.1> pigment { gradient x turbulence 0.5 omega 0.7 lambda 3 } translate <2.667, 1.5, 0> }
box { <-1.25, -1.4, 0>, <1.25, 1.4, 0.1> pigment { gradient x warp { turbulence 0.5 octaves 2 } scale 0.6 } translate <-2.667, -1.5, 0> }
box { <-1.25, -1.4, 0>, <1.25, 1.4, 0.1> pigment { gradient x scale 0.5 turbulence 0.3 rotate z*45 } translate <0, -1.5, 0> }
box { <-1.25, -1.4, 0>, <1.25, 1.4, 0.1> pigment { bozo turbulence 0.8 color_map { [0 rgb 0] [0.5 rgb <0.8, 0.3, 0.1>] [1 rgb <1, 0.95, 0.6>] } scale 0.5 } translate <2.667, -1.5, 0> }
