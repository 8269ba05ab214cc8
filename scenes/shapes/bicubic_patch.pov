// Patches: steps, flatness, unequal steps, none at all, a degenerate corner, surface coordinates, two-sided.
#version 3.7;
global_settings { assumed_gamma 1.0 }

camera { location <0, 2.5, -6> right x*4/3 look_at <0, 1, 0> angle 54 }
light_source { <-6, 9, -8>, rgb 1 }
plane { y, 0 pigment { checker rgb <0.75, 0.72, 0.65> rgb <0.35, 0.38, 0.42> } }

#macro Net()
    <0, 0, 0>, <1, 0, 0.3>, <2, 0, -0.3>, <3, 0, 0>, <0, 1, 0.5>, <1, 1, -2>, <2, 1, 1.5>, <3, 1, 0>,
    <0, 2, 0>, <1, 2, 1.5>, <2, 2, -1.5>, <3, 2, 0.5>, <0, 3, 0>, <1, 3, 0>, <2, 3, 0.5>, <3, 3, 0>
#end
bicubic_patch { type 1 flatness 0.01 u_steps 4 v_steps 4 Net() scale 0.6 translate <-2.9, 0.2, 0> pigment { rgb <0.85, 0.35, 0.2> } finish { specular 0.4 } }
bicubic_patch { type 0 u_steps 3 v_steps 2 Net() scale 0.6 rotate y*20 translate <-0.9, 0.2, 0> pigment { rgb <0.2, 0.5, 0.85> } interior_texture { pigment { rgb <0.9, 0.8, 0.2> } } }
bicubic_patch { type 1 flatness 0.3 u_steps 4 v_steps 4 Net() scale 0.6 rotate y*200 translate <2.9, 0.2, 0> pigment { rgb <0.3, 0.75, 0.35> } interior_texture { pigment { rgb <0.9, 0.4, 0.2> } } }
bicubic_patch { type 1 Net() scale 0.3 translate <-1.6, 0.1, -1.5> pigment { rgb <0.7, 0.3, 0.7> } }
bicubic_patch { type 1 u_steps 3 v_steps 3 uv_vectors <0, 0>, <4, 0>, <2, 3>, <0, 2>
    <0, 0, 0>, <1, 0, 0>, <2, 0, 0>, <3, 0, 0>, <0.5, 1, 0>, <1.1, 1, -1>, <1.9, 1, -1>, <2.5, 1, 0>,
    <1, 2, 0.3>, <1.3, 2, 0>, <1.7, 2, 0>, <2, 2, 0.3>, <1.5, 3, 0>, <1.5, 3, 0>, <1.5, 3, 0>, <1.5, 3, 0>
    scale 0.4 translate <0.3, 0.1, -1.5> uv_mapping pigment { checker rgb <0.8, 0.7, 0.3> rgb <0.2, 0.3, 0.3> } }
