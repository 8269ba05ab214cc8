// Pictures on surfaces: mappings, interpolation, repeat and offset, once, alpha, palettes with filter and transmit, and a function.
#version 3.7;
global_settings { assumed_gamma 1.0 }

camera { location <0, 3.2, -9> right x*4/3 look_at <0, 0.7, 0> angle 46 }
light_source { <-5, 8, -6>, rgb 1 }
plane { y, -0.6 pigment { checker rgb 0.8 rgb 0.55 } }

#declare Board = box { <0, 0, 0>, <1, 1, 0.1> }

object { Board
    pigment { image_map { png "swatch.png" } }
    scale 1.5 translate <-4, 0, 1>
}
object { Board
    pigment { image_map { png "swatch.png" interpolate 2 } }
    scale 1.5 translate <-2.3, 0, 1>
}
object { Board
    pigment { image_map { png "swatch.png" interpolate 3 repeat <2, 1.5> offset <0.1, 0.3> } }
    scale 1.5 translate <-0.6, 0, 1>
}
object { Board
    pigment { image_map { "swatch.png" gamma 1 interpolate 4 } scale 0.4 rotate z*20 }
    scale 1.5 translate <1.1, 0, 1>
}
object { Board
    texture { pigment { rgb <0.3, 0.4, 0.8> } }
    texture { pigment { image_map { png "disc_alpha.png" once interpolate 2 } scale 0.8 translate 0.1 } }
    scale 1.5 translate <2.8, 0, 1>
}
sphere { 0, 0.7
    pigment { image_map { png "swatch.png" map_type 1 interpolate 2 } }
    rotate y*40 translate <-2.4, 0.1, -1.6>
}
cylinder { <0, -0.55, 0>, <0, 0.8, 0>, 0.55
    pigment { image_map { png "rings.png" map_type 2 transmit 1, 0.7 filter 2, 0.8 } }
    translate <-0.5, 0, -1.8>
}
torus { 0.6, 0.3
    pigment { image_map { png "swatch.png" map_type 5 } scale 0.6 }
    rotate x*-40 translate <1.3, 0, -1.7>
}
sphere { 0, 0.6
    uv_mapping
    pigment { image_map { function 40, 30 { pigment { radial frequency 4 color_map { [0 rgb <1,0.8,0.3>] [1 rgb <0.2,0.1,0.5>] } } } } scale <0.5, 1, 1> }
    translate <3, 0, -1.6>
}
