// Surfaces of revolution: closed, open, tapering to nothing, lying, cut, surface coordinates.
#version 3.7;
global_settings { assumed_gamma 1.0 }

camera { location <0, 4, -7> right x*4/3 look_at <0, 0.6, 0> angle 54 }
light_source { <-6, 9, -8>, rgb 1 }
plane { y, 0 pigment { checker rgb <0.75, 0.72, 0.65> rgb <0.35, 0.38, 0.42> } }

sor { 6, <0.2, -0.4>, <0.5, 0>, <0.8, 0.5>, <0.3, 1>, <0.6, 1.5>, <0.5, 1.8>
      translate <-2.2, 0, 1> pigment { rgb <0.85, 0.35, 0.2> } }
sor { 7, <0.2, -0.4>, <0.6, 0>, <0.8, 0.4>, <0.25, 0.8>, <0.3, 1.2>, <0.7, 1.6>, <0.9, 1.7> open sturm
      translate <-0.3, 0, 1> pigment { rgb <0.2, 0.5, 0.85> } interior_texture { pigment { rgb <0.9, 0.8, 0.2> } } }
sor { 5, <0, -0.3>, <0, 0>, <0.8, 0.7>, <0, 1.5>, <0, 1.8>
      rotate z*60 translate <2.4, 0.6, 1> pigment { rgb <0.3, 0.75, 0.35> } finish { specular 0.4 } }
difference {
    sor { 6, <0.2, -0.4>, <0.5, 0>, <0.8, 0.5>, <0.3, 1>, <0.6, 1.5>, <0.5, 1.8> }
    box { <0, -1, -2>, <2, 2, 0> rotate y*-20 }
    scale 0.9 translate <-1.2, 0, -1.5> pigment { rgb <0.75, 0.5, 0.4> }
}
sor { 6, <0.2, -0.4>, <0.5, 0>, <0.8, 0.5>, <0.3, 1>, <0.6, 1.5>, <0.5, 1.8> scale 0.9 translate <1.2, 0, -1.5>
      uv_mapping pigment { checker rgb <0.8, 0.7, 0.3> rgb <0.2, 0.3, 0.3> scale 0.125 } }
