// The five kinds of scattering, each in a ball, lit from the side; shadows fall through the balls.
#version 3.7;
global_settings { assumed_gamma 1.0 }
camera { location <0, 3, -12> look_at <0, 0.2, 0> angle 46 }
light_source { <-9, 7, -2> rgb 1.2 }
light_source { <0, 5, 9> rgb <0.3, 0.35, 0.6> area_light x, y, 3, 3 adaptive 1 }
plane { y, -1.2 pigment { rgb <0.6, 0.55, 0.5> } finish { ambient 0 diffuse 0.7 } }
#macro Ball (Kind, G, Place)
    sphere {
        0, 1.1
        pigment { rgbt 1 } finish { ambient 0 diffuse 0 } hollow
        interior {
            media {
                #if (Kind = 5) scattering { 5, <0.5, 0.6, 0.7> eccentricity G extinction 0.8 }
                #else scattering { Kind, <0.5, 0.6, 0.7> } #end
                density { spherical color_map { [0 rgb 0] [0.4 rgb 0.7] [1 rgb 1.5] } scale 1.1 }
            }
        }
        translate Place
    }
#end
Ball (1, 0, <-3.2, 0.2, 0>)
Ball (2, 0, <-1.1, 0.2, -1>)
Ball (3, 0, <1.1, 0.2, -1>)
Ball (4, 0, <3.2, 0.2, 0>)
Ball (5, 0.5, <-1.4, 1, 2.5>)
Ball (5, -0.5, <1.4, 1, 2.5>)
sphere { <0, -0.6, -2.6>, 0.5 pigment { rgbf <1, 0.6, 0.3, 0.8> } finish { ambient 0 } }
