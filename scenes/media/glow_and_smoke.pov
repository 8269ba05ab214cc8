// Emission and absorption in interiors: patterned densities, several media, moved and scaled containers.
#version 3.7;
global_settings { assumed_gamma 1.0 }
camera { location <0, 2, -9> look_at <0, 0.6, 0> angle 42 }
light_source { <6, 9, -8> rgb 0.9 }
plane { y, -1 pigment { checker rgb 0.75 rgb <0.35, 0.4, 0.5> } }
#declare Clear = texture { pigment { rgbt 1 } finish { ambient 0 diffuse 0 } }
#declare Ball = density { spherical color_map { [0 rgb 0] [0.5 rgb <1, 0.5, 0.2>] [1 rgb <1, 0.9, 0.6>] } }
#declare Fire = media { emission 1.2 density { Ball warp { turbulence 0.3 } } }
sphere { 0, 1 texture { Clear } hollow interior { media { Fire } } scale <1, 1.5, 1> translate <-2.4, 0.6, 0> }
box {
    -0.9, 0.9 texture { Clear } hollow
    interior {
        media { absorption <0.3, 0.9, 1.4> density { bozo scale 0.4 color_map { [0.3 rgb 0] [0.7 rgb 1] } } }
        media { emission <0, 0.05, 0.15> }
    }
    rotate y * 30 translate <0, 0.2, 0.5>
}
union {
    sphere { 0, 0.8 }
    cylinder { 0.4 * y, 1.6 * y, 0.5 }
    texture { pigment { rgbf <0.9, 1, 0.9, 0.95> } finish { ambient 0 diffuse 0 specular 0.5 reflection 0.1 } }
    hollow
    interior {
        ior 1.05
        media {
            samples 20 aa_level 4 aa_threshold 0.05
            absorption 0.8
            density { rgb <0.5, 1, 0.7> }
            density { gradient y density_map { [0 rgb 1] [0.5 granite] [1 rgb 0.1] } scale 2 translate -y }
            translate 0.2 * y
        }
    }
    translate <2.3, -0.2, 0>
}
