// Height fields: flat and smooth, of functions, a pattern and a pigment, under water, cut by and cutting solids.
#version 3.7;
global_settings { assumed_gamma 1.0 }

camera { location <0, 5, -7> right x*4/3 look_at <0, 0.4, 0> angle 45 }
light_source { <-6, 7, -5>, rgb 1 }
plane { y, 0 pigment { checker rgb <0.75, 0.72, 0.65> rgb <0.35, 0.38, 0.42> } }

height_field {
    function 12, 9 { 0.4 + 0.3*sin(9*x)*cos(7*y) }
    translate <-0.5, 0, -0.5>
    scale <1.8, 1, 1.6>
    translate <-2.2, 0, 1>
    pigment { rgb <0.85, 0.35, 0.2> }
}
height_field {
    function 60, 60 { 0.4 + 0.3*sin(9*x)*cos(7*y) }
    smooth
    translate <-0.5, 0, -0.5>
    scale <1.8, 1, 1.6>
    rotate y*20
    translate <0, 0, 1.2>
    pigment { rgb <0.3, 0.7, 0.35> }
    finish { phong 0.5 }
}
height_field {
    function 80, 80 { pattern { granite scale 2 } }
    water_level 0.35
    translate <-0.5, -0.35, -0.5>
    scale <1.8, 1.5, 1.6>
    translate <2.2, 0.05, 1>
    pigment { rgb <0.7, 0.65, 0.5> }
}
intersection {
    height_field {
        function 64, 64 { pigment { wood scale 0.3 translate <0.5, 0.5> color_map { [0 rgb 0.2] [1 rgb <0.9, 0.7, 0.8>] } } }
        translate <-0.5, 0, -0.5>
    }
    cylinder { 0, y, 0.45 }
    scale <1.6, 1, 1.6>
    translate <-1.2, 0.01, -1.4>
    pigment { rgb <0.2, 0.5, 0.85> }
}
difference {
    box { <-0.7, 0, -0.6>, <0.7, 0.9, 0.6> }
    height_field {
        function 30, 30 { 0.5 + 0.4*sin(6*x + 3*y) }
        translate <-0.5, 0, -0.5>
        scale <1.6, 1, 1.4>
    }
    rotate y*-15
    translate <1.2, 0, -1.3>
    pigment { rgb <0.8, 0.75, 0.3> }
}
