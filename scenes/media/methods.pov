// Methods 2 and 3 with their options, each in a box; light through media onto the wall and floor behind.
#version 3.7;
global_settings { assumed_gamma 1.0 }
camera { location <0, 1, -11> look_at <0, 1, 0> angle 46 }
light_source { <-3, 5, -10> rgb 1 }
plane { y, -1.1 pigment { rgb 0.8 } finish { ambient 0 diffuse 0.6 } }
plane { -z, -3 pigment { rgb <0.8, 0.75, 0.6> } finish { ambient 0.1 diffuse 0.7 } }
#declare Glass = texture { pigment { rgbt 1 } finish { ambient 0 diffuse 0 } }
#declare Stuff = media {
    emission <0.1, 0.05, 0.3> absorption 0.3
    density { marble turbulence 0.6 scale 0.8 color_map { [0.2 rgb 0] [0.8 rgb <1.5, 1.2, 1>] } }
}
#macro Cube (Place) box { -0.8, 0.8 texture { Glass } hollow interior { media { Stuff Options() } } rotate 25 * y translate Place } #end
#macro Options () method 2 intervals 2 samples 4 #end
Cube (<-2.6, 2.2, 0>)
#macro Options () method 2 samples 12 #end
Cube (<0, 2.2, 0>)
#macro Options () method 3 intervals 4 samples 4 #end
Cube (<2.6, 2.2, 0>)
#macro Options () samples 30 aa_level 6 aa_threshold 0.005 #end
Cube (<-2.6, 0, 0>)
#macro Options () intervals 2 scattering { 4, 0.3 } #end
Cube (<0, 0, 0>)
#macro Options () rotate 40 * z density { cells scale 0.5 } #end
Cube (<2.6, 0, 0>)
