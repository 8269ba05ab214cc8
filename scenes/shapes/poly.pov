// Polys of orders 2 to 6: clipped, cut, turned, with and without sturm.
#version 3.7;
global_settings { assumed_gamma 1.0 }

camera { location <0, 3.5, -8> right x*4/3 look_at <0, 0.9, 0> angle 48 }
light_source { <-6, 9, -8>, rgb 1 }
plane { y, 0 pigment { checker rgb <0.75, 0.72, 0.65> rgb <0.35, 0.38, 0.42> } }

// x^2 + 0.5 x z + 2 y^2 + z^2 = 0.5
poly {
    2,
    < 1, 0, 0.5, 0, 2, 0, 0, 1, 0, -0.5 >
    translate <2.5, 0.8, 0.8>
    pigment { rgb <0.3, 0.75, 0.35> }
}
// x^4 + y^4 + z^4 = x^2 + y^2 + z^2
poly {
    4,
    < 1, 0, 0, 0, 0, 0, 0, 0, 0, -1, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 1, 0, 0, 0, 0, -1, 0, 0, 0, 0, 1, 0,
      -1, 0, 0 >
    sturm
    scale 0.7
    rotate <20, 30, 0>
    translate <-2.3, 1, 0.5>
    pigment { rgb <0.85, 0.35, 0.2> }
    finish { specular 0.4 roughness 0.03 }
}
// y^5 + x^4 = 1 with z^4, open downwards
intersection {
    poly {
    5,
    < 0, 0, 0, 1, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0,
      0, 0, 1, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 1, 0, 0, 0, -1 >
    }
    box { <-1.5, -0.8, -1.5>, <1.5, 1.5, 1.5> }
    scale 0.7
    rotate y*35
    translate <0.2, 0.56, 1.4>
    pigment { rgb <0.2, 0.5, 0.85> }
}
// x^6 + y^6 + z^6 + 3 x^2 y^2 z^2 = 0.3
intersection {
    poly {
    6,
    < 1, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 3, 0, 0, 0, 0, 0, 0, 0, 0, 0,
      0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 1, 0, 0, 0, 0, 0, 0, 0, 0, 0,
      0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 1, 0, 0, 0, 0, 0, -0.3 >
    }
    plane { <0, 1, -1>, 0.4 }
    rotate y*30
    translate <-0.6, 0.8, -2>
    pigment { rgb <0.8, 0.75, 0.3> }
}
// x^2 + y^2 + z^3 = z^2 + 0.1
poly {
    3,
    < 0, 0, 0, 1, 0, 0, 0, 0, 0, 0, 0, 0, 1, 0, 0, 0, 1, -1, 0, -0.1 >
    clipped_by { box { <-1, -1, -0.8>, <1, 1, 0.8> } }
    rotate <-35, 25, 0>
    scale 0.7
    translate <1.6, 0.7, -1.6>
    pigment { rgb <0.6, 0.4, 0.8> }
}
