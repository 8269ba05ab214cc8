// Lathes: the four splines, open ends that show the inside, one cut by a difference, surface coordinates.
#version 3.7;
global_settings { assumed_gamma 1.0 }

camera { location <0, 4, -7> right x*4/3 look_at <0, 0.6, 0> angle 54 }
light_source { <-6, 9, -8>, rgb 1 }
plane { y, 0 pigment { checker rgb <0.75, 0.72, 0.65> rgb <0.35, 0.38, 0.42> } }

lathe { linear_spline 5, <0.6, 0>, <0.8, 0.6>, <0.3, 0.9>, <0.5, 1.4>, <0.6, 1.5>
        translate <-2.4, 0, 1> pigment { rgb <0.85, 0.35, 0.2> } interior_texture { pigment { rgb <0.9, 0.8, 0.2> } } }
lathe { quadratic_spline 6, <0.2, -0.2>, <0.5, 0>, <0.8, 0.5>, <0.3, 0.9>, <0.4, 1.4>, <0, 1.6>
        translate <-0.7, 0, 1> pigment { rgb <0.2, 0.5, 0.85> } sturm finish { specular 0.4 } }
lathe { cubic_spline 7, <0.3, -0.3>, <0.5, 0>, <0.8, 0.4>, <0.25, 0.8>, <0.2, 1.2>, <0.5, 1.5>, <0.9, 1.7>
        translate <1, 0, 1> pigment { rgb <0.3, 0.75, 0.35> } interior_texture { pigment { rgb <0.9, 0.4, 0.2> } } }
lathe { bezier_spline 8, <0.3, 0.3>, <0.3, -0.1>, <0.8, -0.1>, <0.8, 0.3>, <0.8, 0.3>, <0.8, 0.7>, <0.3, 0.7>, <0.3, 0.3>
        rotate x*-40 translate <2.6, 0.5, 1> pigment { rgb <0.7, 0.3, 0.7> } }
difference {
    lathe { cubic_spline 7, <0.2, -0.3>, <0, 0>, <0.7, 0.2>, <0.4, 0.6>, <0.6, 1>, <0, 1.2>, <0.2, 1.4> }
    box { <0, -1, -2>, <2, 2, 0> rotate y*-20 }
    scale 1.2 translate <-1.2, 0, -1.5> pigment { rgb <0.75, 0.5, 0.4> }
}
lathe { linear_spline 4, <0, 0>, <0.7, 0.3>, <0.4, 0.9>, <0, 1> scale 1.2 translate <1.2, 0, -1.5>
        uv_mapping pigment { checker rgb <0.8, 0.7, 0.3> rgb <0.2, 0.3, 0.3> scale 0.125 } }
