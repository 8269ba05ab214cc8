// Julia fractals: both algebras, square, cube and another function, a slice aside, cut by a solid.
// tolerance: 0.0035 shadows of the fractals on themselves: the reference steps over what is near; without shadows 0.005 %
#version 3.7;
global_settings { assumed_gamma 1.0 }

camera { location <0, 4, -8> right x*4/3 look_at <0, 1, 0> angle 46 }
light_source { <-6, 9, -8>, rgb 1 }
plane { y, 0 pigment { checker rgb <0.75, 0.72, 0.65> rgb <0.35, 0.38, 0.42> } }

julia_fractal {
    <-0.083, 0, -0.83, -0.025>
    quaternion sqr max_iteration 6 precision 300
    rotate y*30
    translate <-2, 1.2, 0.9>
    pigment { rgb <0.85, 0.35, 0.2> }
}
julia_fractal {
    <0.2, 0.3, -0.4, 0.1>
    quaternion cube max_iteration 5 precision 300
    translate <0.4, 1.1, 1.2>
    pigment { rgb <0.3, 0.7, 0.35> }
    finish { phong 0.5 }
}
julia_fractal {
    <0.2, 0.1, 0.59, -0.2>
    hypercomplex sqr max_iteration 5 precision 300
    scale 0.8
    translate <2.5, 1.1, 0.8>
    pigment { rgb <0.2, 0.5, 0.85> }
}
difference {
    julia_fractal { <-0.1, 0.5, -0.2, -0.3> quaternion sqr max_iteration 5 precision 300 slice <0.2, 0, 0, 1>, 0.1 }
    box { <-2, 0.1, -2>, <2, 2, 0> }
    scale 0.8
    translate <-1, 0.9, -1.6>
    pigment { rgb <0.8, 0.75, 0.3> }
}
