// Sphere sweeps: the three splines, growing and shrinking, crossing themselves, stretched, and cut open.
#version 3.7;
global_settings { assumed_gamma 1.0 }

camera { location <0, 4, -8> right x*4/3 look_at <0, 0.9, 0> angle 46 }
light_source { <-6, 9, -8>, rgb 1 }
plane { y, 0 pigment { checker rgb <0.75, 0.72, 0.65> rgb <0.35, 0.38, 0.42> } }

sphere_sweep {
    linear_spline 4, <-1, 0.3, 0>, 0.3, <-0.6, 1.8, 0.3>, 0.15, <0.2, 0.5, -0.3>, 0.35, <0.8, 1.6, 0>, 0.1
    translate <-2.2, 0, 0.8>
    pigment { rgb <0.85, 0.35, 0.2> }
}
sphere_sweep {
    b_spline 7, <-1, 0, 0>, 0.1, <-1, 1, 0>, 0.4, <0, 2, 1>, 0.1, <1, 1, 0>, 0.4, <0, 0, -1>, 0.3, <-1, 1, 0>, 0.2, <-1, 2, 0>, 0.1
    translate <0.1, 0.5, 0.9>
    pigment { rgb <0.3, 0.7, 0.35> }
    finish { phong 0.6 }
}
sphere_sweep {
    cubic_spline 6, <-1, 0, 0>, 0.1, <-0.7, 0.5, 0>, 0.3, <0, 1.4, 0.3>, 0.1, <0.5, 0.4, -0.2>, 0.4, <0.9, 1.3, 0>, 0.15, <2, 1, 0>, 0.1
    translate <2.3, 0, 0.6>
    pigment { rgb <0.2, 0.5, 0.85> }
}
difference {
    sphere_sweep { cubic_spline 5, <-2, 0, 0>, 0.3, <-0.8, 0.3, 0>, 0.3, <0, 0.7, 0>, 0.5, <0.8, 0.3, 0>, 0.3, <2, 0, 0>, 0.3 }
    box { <-2, 0.4, -1>, <2, 2, 0> }
    translate <-1.3, 0, -1.5>
    pigment { rgb <0.8, 0.75, 0.3> }
}
sphere_sweep {
    b_spline 8,
    <1, 0, 0>, 0.15, <0, 0, 1>, 0.15, <-1, 0, 0>, 0.15, <0, 0, -1>, 0.15,
    <1, 0, 0>, 0.15, <0, 0, 1>, 0.15, <-1, 0, 0>, 0.15, <0, 0, -1>, 0.15
    scale <1, 2, 1>
    rotate <-20, 0, 15>
    translate <1.4, 0.6, -1.6>
    pigment { rgb <0.6, 0.4, 0.8> }
}
