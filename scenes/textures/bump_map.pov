// Pictures as heights that turn the normal: size, interpolation, palette indices, once, wrapped around a sphere.
#version 3.7;
global_settings { assumed_gamma 1.0 }

camera { location <0, 2.6, -7.5> right x*4/3 look_at <0, 0.5, 0> angle 44 }
light_source { <-6, 7, -5>, rgb 1 }
plane { y, -0.6 pigment { rgb 0.6 } }

#default { finish { phong 0.6 phong_size 30 } }
#declare Board = box { <0, 0, 0>, <1, 1, 0.1> pigment { rgb <0.8, 0.6, 0.4> } }

object { Board normal { bump_map { png "swatch.png" bump_size 2 } } scale 1.5 translate <-3.2, 0, 1> }
object { Board normal { bump_map { png "swatch.png" interpolate 2 } , 3 } scale 1.5 translate <-1.5, 0, 1> }
object { Board normal { bump_map { png "rings.png" use_index once } bump_size 0.5 scale 0.8 } scale 1.5 translate <0.2, 0, 1> }
object { Board normal { bump_map { png "rings.png" interpolate 3 } -2 scale 0.5 } scale 1.5 translate <1.9, 0, 1> }
sphere { 0, 0.8
    pigment { rgb <0.4, 0.6, 0.8> }
    normal { bump_map { png "rings.png" map_type 1 interpolate 2 bump_size 1.5 } }
    translate <-1.4, 0.2, -1.4>
}
sphere { 0, 0.8
    pigment { image_pattern { png "rings.png" } color_map { [0 rgb <0.9, 0.2, 0.1>] [0.5 rgb 1] [1 rgb <0.1, 0.3, 0.7>] } scale 0.7 }
    translate <1.4, 0.2, -1.4>
}
