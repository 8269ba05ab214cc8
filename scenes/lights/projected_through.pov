// projected_through: a light shines only where its way leads through an object that nobody sees.
#version 3.7;
global_settings { assumed_gamma 1.0 }

camera { location <0, 4.5, -7> right x*4/3 look_at <0, 0.2, 0.4> angle 52 }
plane { y, 0 pigment { rgb 0.85 } finish { ambient 0.05 diffuse 0.8 } }
plane { -z, -4 pigment { rgb <0.8, 0.8, 0.9> } finish { ambient 0.05 diffuse 0.8 } }

// A pane with holes; behind it, as the light goes, a ball that casts a shadow, and before it one that does not.
#declare Pane = difference {
    box { <-1.2, 2, -1.2>, <1.2, 2.05, 1.2> }
    cylinder { <-0.4, 1, 0>, <-0.4, 3, 0>, 0.3 }
    box { <0.2, 1, -0.6>, <0.6, 3, 0.6> }
}
light_source { <0, 6, 0>, rgb <1, 0.9, 0.7> projected_through { object { Pane } } translate <-1.6, 0, 0.4> }
sphere { <-2.2, 0.8, 0>, 0.3 pigment { rgb <0.9, 0.4, 0.3> } finish { ambient 0.05 } }
sphere { <-1.2, 3.4, 1>, 0.3 pigment { rgb <0.4, 0.9, 0.3> } finish { ambient 0.05 } }

// An area light through a ring: a soft edge. A clear disc below the ring tints it.
light_source {
    <1.8, 5, 0.2>, rgb <0.6, 0.8, 1>
    area_light <0.8, 0, 0>, <0, 0, 0.8>, 5, 5 adaptive 2
    projected_through { torus { 0.7, 0.25 translate <1.8, 2, 0.2> } }
}
disc { <2.3, 1, 0.2>, y, 0.8 pigment { rgbf <1, 0.6, 0.6, 0.8> } finish { ambient 0.05 } }
// A lamp without shadows that shines through two windows at once.
light_source {
    <0, 1.5, -3>, rgb 0.6 shadowless
    projected_through { union { box { <-0.9, 1.3, 0>, <-0.2, 2, 0.1> } sphere { <0.6, 1.6, 0>, 0.4 } } }
}
