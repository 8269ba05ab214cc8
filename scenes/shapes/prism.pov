// Prisms: the four splines, a hole, open, a cone to its apex and beyond, one lying in a difference.
#version 3.7;
global_settings { assumed_gamma 1.0 }

camera { location <0, 5, -7> right x*4/3 look_at <0, 0.3, 0> angle 50 }
light_source { <-6, 9, -8>, rgb 1 }
plane { y, 0 pigment { checker rgb <0.75, 0.72, 0.65> rgb <0.35, 0.38, 0.42> } }

prism { 0, 0.6, 10, <-0.7, -0.6>, <0.7, -0.6>, <0.7, 0.6>, <-0.7, 0.6>, <-0.7, -0.6>,
        <-0.3, -0.3>, <0.3, -0.3>, <0, 0.4>, <-0.35, 0.2>, <-0.3, -0.3>
        translate <-2.2, 0, 1> pigment { rgb <0.85, 0.35, 0.2> } }
prism { quadratic_spline 0, 0.8, 6, <-0.7, 0.1>, <-0.6, -0.5>, <0.5, -0.6>, <0.7, 0.5>, <-0.3, 0.7>, <-0.6, -0.5>
        translate <-0.6, 0, 1.2> pigment { rgb <0.2, 0.5, 0.85> } finish { specular 0.4 } }
prism { cubic_spline 0, 0.5, 7, <-0.6, 0.5>, <-0.5, -0.5>, <0.6, -0.5>, <0.5, 0.6>, <-0.6, 0.5>, <-0.5, -0.5>, <0.6, -0.5>
        open translate <0.9, 0, 1.2> pigment { rgb <0.3, 0.75, 0.35> } interior_texture { pigment { rgb <0.9, 0.8, 0.2> } } }
prism { bezier_spline 0, 1, 8, <-0.5, 0>, <-0.5, 0.8>, <0.6, 0.5>, <0.5, 0>, <0.5, 0>, <0.4, -0.5>, <-0.5, -0.9>, <-0.5, 0>
        translate <2.4, 0, 1> pigment { rgb <0.7, 0.3, 0.7> } sturm }
prism { conic_sweep linear_spline 0, 1, 5, <-0.5, -0.5>, <0.5, -0.5>, <0.6, 0.5>, <-0.5, 0.6>, <-0.5, -0.5>
        rotate x*180 translate <-2, 1, -1> pigment { rgb <0.8, 0.7, 0.3> } }
prism { conic_sweep cubic_spline -0.7, 0.8, 7, <-0.6, 0.5>, <-0.5, -0.5>, <0.6, -0.5>, <0.5, 0.6>, <-0.6, 0.5>, <-0.5, -0.5>, <0.6, -0.5>
        open translate <-0.4, 0.7, -1.2> pigment { rgb <0.3, 0.7, 0.75> } interior_texture { pigment { rgb <0.9, 0.4, 0.2> } } }
difference {
    prism { linear_sweep cubic_spline -0.9, 0.9, 14, <-0.6, 0.5>, <-0.5, -0.5>, <0.6, -0.5>, <0.5, 0.6>, <-0.6, 0.5>, <-0.5, -0.5>, <0.6, -0.5>,
            <0.2, -0.2>, <0.2, 0.2>, <-0.2, 0.2>, <-0.2, -0.2>, <0.2, -0.2>, <0.2, 0.2>, <-0.2, 0.2>
            rotate <75, 30, 0> }
    box { <0.1, 0, -2>, <2, 2, 2> }
    translate <1.6, 0.7, -1.2> pigment { rgb <0.75, 0.5, 0.4> }
}
