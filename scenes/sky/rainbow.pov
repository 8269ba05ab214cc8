// Two bows, the outer one fainter and fading to its ends, over a mirror and behind glass; one lies, near.
#version 3.7;
global_settings { assumed_gamma 1.0 }

camera { location <0, 1.5, -6> right x*4/3 look_at <0, 1.8, 0> angle 70 }
light_source { <3, 8, -12>, rgb 1 }
background { rgb <0.35, 0.42, 0.52> }
#declare Bow = color_map {
    [0.00 rgbft <0.6, 0.2, 0.9, 0.1, 1>]
    [0.10 rgbft <0.6, 0.2, 0.9, 0.1, 0.7>]
    [0.40 rgbft <0.2, 0.7, 0.9, 0.1, 0.5>]
    [0.60 rgbft <0.3, 0.9, 0.3, 0.1, 0.5>]
    [0.75 rgbft <1.0, 0.9, 0.2, 0.1, 0.5>]
    [0.90 rgbft <1.0, 0.2, 0.1, 0.1, 0.7>]
    [1.00 rgbft <1.0, 0.2, 0.1, 0.1, 1>]
}
rainbow { direction <0, -0.05, 1> angle 24 width 7 distance 10 color_map { Bow } }
rainbow { direction <0, -0.05, 1> up <0.2, 1, 0> angle 32 width 5 distance 30 arc_angle 130 falloff_angle 60 color_map { Bow } }
rainbow { direction <1, -1, 1> up <-1, 0, 1> angle 34 width 6 distance 4 color_map { Bow } }
plane { y, 0 pigment { checker rgb <0.4, 0.35, 0.3> rgb <0.3, 0.32, 0.35> } finish { reflection 0.35 } }
sphere { <1.8, 1, 0>, 1 hollow pigment { rgbf <0.9, 0.95, 1, 0.85> } finish { reflection 0.1 specular 0.5 } interior { ior 1.4 } }
box { <-3, 0, 2>, <-1.4, 2.6, 3> pigment { rgb <0.6, 0.3, 0.25> } }
