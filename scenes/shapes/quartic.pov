// Algebraic surfaces: a torus as quartic, a cubic, two polys of orders 2 and 6, cut by boxes.
#version 3.7;
global_settings { assumed_gamma 1.0 }

camera { location <0, 3.5, -8> right x*4/3 look_at <0, 0.9, 0> angle 48 }
light_source { <-6, 9, -8>, rgb 1 }
plane { y, 0 pigment { checker rgb <0.75, 0.72, 0.65> rgb <0.35, 0.38, 0.42> } }

// (x^2 + y^2 + z^2 + 0.55)^2 = 2.56 (x^2 + z^2): a torus of radii 0.8 and 0.3
quartic {
    < 1, 0, 0, 0, 2, 0, 0, 2, 0, -1.46, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0,
      1, 0, 0, 2, 0, 1.1, 0, 0, 0, 0, 1, 0, -1.46, 0, 0.3025 >
    sturm
    rotate x*-50
    translate <-2.2, 1, 0.5>
    pigment { rgb <0.85, 0.35, 0.2> }
}
// x^3 - 3 x z^2 = y
cubic {
    < 1, 0, 0, 0, 0, 0, 0, -3, 0, 0, 0, 0, 0, 0, 0, -1, 0, 0, 0, 0 >
    clipped_by { box { <-0.9, -0.9, -0.9>, <0.9, 0.9, 0.9> } }
    rotate y*20
    translate <0.2, 1, 1>
    pigment { rgb <0.2, 0.5, 0.85> }
}
poly {
    2, < 1, 0, 0.5, 0, 2, 0, 0, 1, 0, -0.5 >
    translate <2.4, 0.8, 0.5>
    pigment { rgb <0.3, 0.75, 0.35> }
}
// x^6 + y^6 + z^6 = 0.3, and 0.2 x^2 y^2 z^2 besides
intersection {
    poly {
        6, < 1, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0.2, 0, 0, 0, 0,
             0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0,
             1, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 1, 0, 0, 0, 0, 0, -0.3 >
    }
    plane { <0, 1, -1>, 0.4 }
    rotate y*30
    translate <-0.2, 0.8, -2>
    pigment { rgb <0.8, 0.75, 0.3> }
}
