// Blobs: merging balls, a cylinder, a negative part, own textures that blend, stretched components, the old syntax.
#version 3.7;
global_settings { assumed_gamma 1.0 }

camera { location <0, 3, -7> right x*4/3 look_at <0, 0.9, 0> angle 52 }
light_source { <-6, 9, -8>, rgb 1 }
plane { y, 0 pigment { checker rgb <0.75, 0.72, 0.65> rgb <0.35, 0.38, 0.42> } }

blob {
    threshold 0.5
    sphere { <-0.4, 0, 0>, 0.9, 1 }
    sphere { <0.4, 0.2, 0>, 0.8, strength 1.2 }
    cylinder { <0, 0, 0>, <0, 1.2, 0.3>, 0.45, 1 }
    sphere { <0, 0.1, -0.7>, 0.5, -1 }
    translate <-2, 0.7, 0.6>
    pigment { rgb <0.85, 0.35, 0.2> }
    finish { specular 0.4 roughness 0.03 }
}
blob {
    threshold 0.6
    sphere { <-0.5, 0, 0>, 1, 1.1 pigment { rgb <0.9, 0.8, 0.2> } finish { phong 0.8 } }
    sphere { <0.5, 0, 0>, 1, 1.1 texture { pigment { rgb <0.2, 0.3, 0.9> } } }
    cylinder { <0, 0, 0>, <0, 1, 0>, 0.5, 1 rotate z*25 scale <1, 1, 1.5> }
    sphere { 0, 0.7, 1 pigment { checker rgb 1 rgb <0.8, 0.1, 0.1> scale 0.1 } scale <1, 0.5, 1> rotate x*30 translate <0, -0.2, -0.7> }
    pigment { rgb <0.3, 0.75, 0.35> }
    rotate y*20
    translate <1.2, 0.9, 0>
    hierarchy off
    sturm
}
blob {
    threshold 0.3
    component 1, 0.4, <-0.25, 0, 0>
    component 1, 0.4, <0.25, 0, 0>
    scale <1, 1.6, 1>
    translate <-0.4, 0.5, -2.2>
    pigment { rgb <0.6, 0.4, 0.8> }
}
