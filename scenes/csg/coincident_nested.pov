// Coincident faces of children of compounds within compounds: which child is seen alternates with the level.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 3, -9> right 4/3*x look_at <0, -.2, 0> angle 50 }
light_source { <-5, 8, -9> rgb 1 }
#default { finish { ambient .3 } }

#declare Left = box { <-1, -1, -1>, <.3, 1, 1> pigment { rgb <1, .3, .2> } }
#declare Right = box { <-.3, -1, -1>, <1, 1, 1> pigment { rgb <.2, .9, .3> } }
#declare Both = union { object { Left } object { Right } };
union { object { Both } split_union off translate <-2.6, 1.2, 0> }
intersection { object { Both } box { -1.5, 1.5 pigment { rgb 1 } } translate <0, 1.2, 0> }
intersection {
  intersection { object { Both } box { -1.5, 1.5 pigment { rgb 1 } } }
  box { -1.4, 1.4 pigment { rgb 1 } }
  translate <2.6, 1.2, 0>
}
difference { object { Both } sphere { <0, 1, -1>, .6 pigment { rgb <.3, .4, 1> } } translate <-2.6, -1.6, 0> }
intersection {
  union { object { Both } box { <-.8, -.8, -1>, <.8, -.2, 1> pigment { rgb <1, 1, .3> } } }
  plane { y, .8 pigment { rgb <.3, .4, 1> } }
  translate <0, -1.6, 0>
}
union { object { Both } clipped_by { sphere { 0, 1.5 } } translate <2.6, -1.6, 0> }
