// Light groups: each stand has lights of its own; shadows fall from everything, whoever's light it is.
#version 3.7;
global_settings { assumed_gamma 1.0 }

camera { location <0, 4.2, -8> right x*4/3 look_at <0, 0.7, 0> angle 48 }
#default { finish { ambient 0.03 diffuse 0.8 } }

#declare Matt = texture { pigment { rgb 0.85 } }
plane { y, 0 pigment { checker rgb 0.8, rgb 0.5 } }
light_source { <-4, 8, -6>, rgb 0.5 }

// Only its own light; the lamp's body sees the global one, too.
light_group {
    light_source { <-2.6, 2.4, -1.6>, rgb <1, 0.5, 0.3>
        looks_like { sphere { 0, 0.15 pigment { rgb <1, 0.7, 0.5> } finish { ambient 0.4 } } }
    }
    cylinder { <-2.6, 0, 0>, <-2.6, 0.6, 0>, 0.9 texture { Matt } }
    sphere { <-2.6, 1.1, 0>, 0.5 pigment { rgb <0.9, 0.9, 0.6> } finish { phong 0.6 } }
}
// Both, a spotlight; a group within the group takes its light, a union in it as well.
light_group {
    light_source { <0, 4, -3>, rgb <0.3, 1, 0.4> spotlight point_at <0, 0.5, 0> radius 12 falloff 17 }
    union {
        box { <-0.7, 0, -0.7>, <0.7, 0.6, 0.7> }
        cone { <0, 0.6, 0>, 0.5, <0, 1.6, 0>, 0.1 }
        texture { Matt }
    }
    light_group { sphere { <0, 1.75, 0>, 0.25 texture { Matt } } }
    global_lights on
}
// An area light; moved as a whole. The inner group has its own light and none of the outer's.
light_group {
    light_source { <-1, 3, -2>, rgb <0.4, 0.5, 1> area_light <1.3, 0, 0>, <0, 0, 1.3>, 4, 4 adaptive 1 }
    difference {
        box { <-0.8, 0, -0.8>, <0.8, 1, 0.8> }
        sphere { <0, 1, -0.3>, 0.6 }
        texture { Matt }
    }
    torus { 0.7, 0.12 translate y*1.1 texture { pigment { gradient x color_map { [0 rgb 1] [1 rgb <1, 0.3, 0.3>] } } } }
    light_group {
        light_source { <1.5, 2, -2>, rgb <1, 1, 0.4> }
        sphere { <0, 1.4, 0>, 0.3 texture { Matt } }
    }
    rotate y*25
    translate <2.6, 0, 0>
}
// A mirror that shows them all, in a group without light.
light_group {
    box { <-4, 0, 2.4>, <4, 2.6, 2.5> pigment { rgb 0 } finish { reflection 0.7 } }
}
