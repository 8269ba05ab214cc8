// checker: default colours, scaled, turned, as the only list of a pigment identifier.
#version 3.7;
global_settings { assumed_gamma 1.0 }

camera { orthographic location <0, 0, -5> right x*8 up y*6 look_at 0 }
light_source { <0, 0, -100>, rgb 1 }
#default { finish { ambient 0.2 diffuse 0.8 } }
box { <-1.25, -1.4, 0>, <1.25, 1.4, 0.1> pigment { checker } translate <-2.667, 1.5, 0> }
box { <-1.25, -1.4, 0>, <1.25, 1.4, 0.1> pigment { checker rgb 1, rgb <0.7, 0.2, 0.1> scale 0.4 } translate <0, 1.5, 0> }
box { <-1.25, -1.4, 0>, <1.25, 1.4, 0.1> pigment { checker rgb 0.9 rgb 0.2 scale <0.3, 0.8, 1> rotate z*25 } translate <2.667, 1.5, 0> }
box { <-1.25, -1.4, 0>, <1.25, 1.4, 0.1> pigment { checker rgb <0.9, 0.8, 0.2> translate <0.3, 0.2, 0.1> } translate <-2.667, -1.5, 0> }
box { <-1.25, -1.4, 0>, <1.25, 1.4, 0.1> pigment { checker pigment { rgb 0.9 } pigment { gradient x scale 0.2 } scale 0.6 } translate <0, -1.5, 0> }
box { <-1.25, -1.4, 0>, <1.25, 1.4, 0.1> pigment { checker rgb 1 rgb 0 scale 0.05 } translate <2.667, -1.5, 0> }
