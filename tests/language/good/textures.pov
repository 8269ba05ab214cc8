#version 3.7;
global_settings { assumed_gamma 1 }
#default { finish { ambient .2 diffuse .7 } }
#declare Veined = pigment { marble turbulence .7 octaves 4 omega .6 lambda 2.1 color_map { [0, .5 color rgb 0 color rgb 1] [.5, 1 color rgb 1 color rgb 0] } }
#declare Two = texture { pigment { Veined scale 2 } normal { bumps .3 scale .1 } } texture { pigment { rgbt <0, 1, 0, .5> } }
sphere { 0, 1 texture { Two rotate 45*z } }
box { 0, 1 texture { gradient x texture_map { [0 Two] [1 pigment { rgb 1 } finish { specular .5 roughness .01 metallic }] } frequency 3 } }
box { 0, 1 pigment { wood pigment_map { [0 Veined] [1 rgb <1, 0, 0>] } warp { repeat 2*x flip y } warp { turbulence .1 octaves 3 } sine_wave phase .25 } }
box { 0, 1 pigment { brick rgb .2, rgb .8 brick_size <4, 2, 2> mortar .3 } normal { ripples slope_map { [0 <0, 1>] [1 <1, 0>] } } }
box { 0, 1 pigment { average pigment_map { [1 checker rgb 1 rgb 0] [2 Veined] } } }
box { 0, 1 pigment { function { x*x + y } color_map { [0 rgb 0] [1 rgb 1] } } finish { reflection { 0, 1 fresnel on falloff 2 exponent .5 metallic } conserve_energy } }
box { 0, 1 uv_mapping pigment { hexagon rgb 1 rgb 0 rgb .5 } interior_texture { pigment { Veined } } }
box { 0, 1 texture { checker texture { Two } texture { pigment { rgb 1 } } } }
box { 0, 1 material { texture { Two } interior { ior 1.2 } scale 3 } inverse hollow }
