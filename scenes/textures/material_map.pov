// One texture for each color of a palette; transformed, and with more colors than textures.
#version 3.7;
global_settings { assumed_gamma 1.0 }

camera { location <0, 2.2, -6> right x*4/3 look_at <0, 0.7, 0> angle 44 }
light_source { <-6, 7, -5>, rgb 1 }
plane { y, 0 pigment { rgb 0.6 } }

#declare Red = texture { pigment { rgb <0.9, 0.2, 0.1> } finish { phong 0.8 } }
#declare Glossy = texture { pigment { rgb <0.2, 0.3, 0.4> } finish { reflection 0.4 } }
#declare Spots = texture { pigment { checker rgb 1 rgb <0.2, 0.6, 0.2> scale 0.04 } }

box { 0, <1, 1, 0.1>
    texture { material_map { png "rings.png" texture { Red } texture { Glossy } texture { Spots } } }
    scale 1.8 translate <-2.1, 0, 0>
}
box { 0, <1, 1, 0.1>
    texture {
        material_map { png "rings.png" map_type 0 texture { Spots } texture { Red } texture { Glossy } texture { Red } texture { Spots } }
        rotate z*30 scale 0.6
    }
    scale 1.8 translate <0.3, 0, 0>
}
