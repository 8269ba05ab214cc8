// bozo, granite, agate, wrinkles, dents, spotted.
#version 3.7;
global_settings { assumed_gamma 1.0 }

camera { orthographic location <0, 0, -5> right x*8 up y*6 look_at 0 }
light_source { <0, 0, -100>, rgb 1 }
#default { finish { ambient 0.2 diffuse 0.8 } }
box { <-1.25, -1.4, 0>, <1.25, 1.4, 0.1> pigment { bozo scale 0.4 } translate <-2.667, 1.5, 0> }
box { <-1.25, -1.4, 0>, <1.25, 1.4, 0.1> pigment { granite scale 0.8 } translate <0, 1.5, 0> }
box { <-1.25, -1.4, 0>, <1.25, 1.4, 0.1> pigment { agate scale 0.5 } translate <2.667, 1.5, 0> }
box { <-1.25, -1.4, 0>, <1.25, 1.4, 0.1> pigment { wrinkles scale 0.5 } translate <-2.667, -1.5, 0> }
box { <-1.25, -1.4, 0>, <1.25, 1.4, 0.1> pigment { dents scale 0.3 } translate <0, -1.5, 0> }
box { <-1.25, -1.4, 0>, <1.25, 1.4, 0.1> pigment { spotted color_map { [0.3 rgb <0.2, 0.3, 0.6>] [0.6 rgb 1] } scale 0.3 } translate <2.667, -1.5, 0> }
