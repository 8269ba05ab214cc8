#version 3.7;
global_settings { assumed_gamma 1.0 max_trace_level 8 ambient_light rgb <1, .9, .8> }
background { rgb <.1, .2, .3> }
camera { location <0, 2, -5> look_at <0, 1, 0> angle 40 right x*image_width/image_height }
light_source { <10, 20, -10>, rgb 1 }
plane { y, 0 pigment { checker rgb 1, rgb <1, 0, 0> scale 2 } finish { reflection .2 } }
sphere { <0, 1, 0>, 1 texture { pigment { color rgb <.2, .3, 1> } finish { phong 1 phong_size 60 } } translate x }
difference {
    box { -1, 1 }
    sphere { 0, 1.3 }
    pigment { bozo turbulence .5 color_map { [0 rgb 0] [0.5 color rgb <1, 1, 0> filter .25] [1 rgbt <1, 1, 1, .5>] } }
    rotate y*30
    interior { ior 1.5 fade_distance 2 fade_power 1 }
    no_shadow
}
