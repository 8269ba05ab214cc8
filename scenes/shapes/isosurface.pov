// Isosurfaces: closed and open, in a box and in a sphere, cut, with noise, with evaluate, a threshold, all crossings in a CSG.
#version 3.7;
#include "functions.inc"
global_settings { assumed_gamma 1.0 }

camera { location <0, 4, -8> right x*4/3 look_at <0, 0.8, 0> angle 48 }
light_source { <-6, 9, -8>, rgb 1 }
plane { y, 0 pigment { checker rgb <0.75, 0.72, 0.65> rgb <0.35, 0.38, 0.42> } }

isosurface {
    function { x*x + y*y + z*z - 1 + 0.1*sin(10*x)*sin(7*y) }
    contained_by { box { <-1.2, -0.9, -1.2>, <1.2, 0.8, 1.2> } }
    max_gradient 4
    translate <-2.3, 0.9, 0.5>
    pigment { rgb <0.85, 0.35, 0.2> }
}
isosurface {
    function { f_torus(x, y, z, 0.7, 0.25) }
    contained_by { sphere { 0, 0.9 } }
    threshold 0.05
    accuracy 0.0005
    max_gradient 1.3
    open
    rotate x*-50
    translate <0, 0.9, 0.4>
    pigment { rgb <0.2, 0.5, 0.85> }
}
isosurface {
    function { sqrt(x*x + y*y + z*z) - 0.7 + 0.25*f_noise3d(x*4, y*4, z*4) }
    contained_by { sphere { 0, 1 } }
    max_gradient 3
    translate <2.2, 0.7, 0.4>
    pigment { rgb <0.3, 0.75, 0.35> }
}
difference {
    isosurface {
        function { y - 0.3*cos(4*x)*cos(4*z) }
        contained_by { box { <-1, -0.6, -0.6>, <1, 0.5, 0.6> } }
        max_gradient 2
        all_intersections
    }
    cylinder { -z, z, 0.3 }
    translate <-1, 0.6, -2>
    pigment { rgb <0.8, 0.75, 0.3> }
}
isosurface {
    function { abs(x) + abs(y) + abs(z) - 0.6 }
    evaluate 1, 1.2, 0.9
    max_trace 2
    scale <1, 1.4, 1>
    translate <1.3, 0.8, -1.8>
    pigment { rgb <0.6, 0.4, 0.8> }
}
