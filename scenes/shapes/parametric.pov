// Parametric surfaces: a band, a shell cut by its container, a surface of one turn, uv mapping.
// tolerance: 0.007 shadows within the ends of the tube, which the reference leaves out; without shadows 0.15 %
#version 3.7;
global_settings { assumed_gamma 1.0 }

camera { location <0, 4, -8> right x*4/3 look_at <0, 0.9, 0> angle 46 }
light_source { <-6, 9, -8>, rgb 1 }
plane { y, 0 pigment { checker rgb <0.75, 0.72, 0.65> rgb <0.35, 0.38, 0.42> } }

parametric {
    function { (1 + v*cos(u/2))*cos(u) }, function { v*sin(u/2) }, function { (1 + v*cos(u/2))*sin(u) }
    <0, -0.4>, <2*pi, 0.4>
    contained_by { box { <-1.5, -0.5, -1.5>, <1.5, 0.5, 1.5> } }
    max_gradient 2 accuracy 0.0005 precompute 12 x, y, z
    rotate x*-40
    translate <-2, 1.1, 0.8>
    pigment { rgb <0.85, 0.35, 0.2> }
}
parametric {
    function { (0.8 + 0.35*cos(v))*cos(u) }, function { 0.35*sin(v) + 0.05*u }, function { (0.8 + 0.35*cos(v))*sin(u) }
    <0, 0>, <4, 2*pi>
    contained_by { sphere { <0, 0.1, 0>, 1.05 } }
    max_gradient 2 accuracy 0.0005 precompute 12 x, y, z
    rotate <-60, 30, 0>
    translate <0.6, 1.2, 1.2>
    pigment { rgb <0.3, 0.7, 0.35> }
    finish { phong 0.5 }
}
parametric {
    function { u }, function { 0.4*sin(4*u)*cos(3*v) }, function { v }
    <-0.9, -0.9>, <0.9, 0.9>
    contained_by { box { -1, 1 } }
    max_gradient 2.5 accuracy 0.0005 precompute 12 x, y, z
    rotate <-25, 20, 0>
    translate <1.9, 0.9, -0.9>
    uv_mapping
    pigment { checker rgb <0.9, 0.8, 0.3> rgb <0.2, 0.4, 0.8> scale 0.3 }
}
parametric {
    function { sin(u)*cos(v) }, function { sin(u)*sin(v) }, function { cos(u) }
    <0.3, 0>, <pi - 0.3, 1.6*pi>
    contained_by { box { -1.01, 1.01 } }
    max_gradient 1.5 accuracy 0.0005 precompute 12 x, y, z
    scale <0.6, 0.8, 0.6>
    rotate y*160
    translate <-0.9, 0.85, -1.6>
    pigment { rgb <0.2, 0.5, 0.85> }
}
