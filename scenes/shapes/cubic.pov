// Cubic surfaces: a drop with a point, one with four cones, a saddle for three; clipped, cut, in a CSG.
#version 3.7;
global_settings { assumed_gamma 1.0 }

camera { location <0, 3.5, -8> right x*4/3 look_at <0, 0.9, 0> angle 48 }
light_source { <-6, 9, -8>, rgb 1 }
plane { y, 0 pigment { checker rgb <0.75, 0.72, 0.65> rgb <0.35, 0.38, 0.42> } }

// x^2 + z^2 = (1 - y) y^2
cubic {
    < 0, 0, 0, 1, 0, 0, 0, 0, 0, 0, 1, 0, -1, 0, 0, 0, 0, 1, 0, 0 >
    clipped_by { box { <-2, -0.9, -2>, <2, 1.1, 2> } }
    translate <-2.2, 0.9, 0.3>
    pigment { rgb <0.85, 0.35, 0.2> }
    finish { specular 0.4 roughness 0.03 }
}
// x^2 + y^2 + z^2 - 2 x y z = 1
intersection {
    cubic {
    < 0, 0, 0, 1, 0, -2, 0, 0, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, -1 >
    }
    sphere { 0, 2.4 }
    scale 0.6
    rotate <-20, 25, 0>
    translate <0.2, 1.2, 0.6>
    pigment { rgb <0.2, 0.5, 0.85> }
}
// x^3 - 3 x z^2 = 2 y
cubic {
    < 1, 0, 0, 0, 0, 0, 0, -3, 0, 0, 0, 0, 0, 0, 0, -2, 0, 0, 0, 0 >
    clipped_by { sphere { 0, 0.9 } }
    rotate <-15, 20, 0>
    translate <2.4, 1, 0>
    pigment { rgb <0.3, 0.75, 0.35> }
}
difference {
    box { -0.6, 0.6 }
    cubic {
    < 1, 0, 0, 0, 0, 0, 0, 0, 0, 0, 1, 0, 0, 0, 0, 0, 1, 0, 0, -0.02 >
    }
    rotate <10, 50, 0>
    translate <-0.8, 0.8, -2>
    pigment { rgb <0.8, 0.75, 0.3> }
}
