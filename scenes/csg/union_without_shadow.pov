// A union that stays whole has no shadow if none of its parts has one; one part with a shadow gives it to all.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 4, -8> right 4/3*x look_at <0, 0, 0> }
light_source { <-4, 8, -5> rgb 1 }
plane { y, -1 pigment { rgb .8 } }
union {
  sphere { 0, 1 no_shadow }
  sphere { x, .8 no_shadow }
  split_union off
  pigment { rgb <1, .3, .2> }
  translate -2.2*x
}
union {
  sphere { 0, 1 no_shadow }
  sphere { x, .8 }
  split_union off
  pigment { rgb <.2, .9, .3> }
  translate 1.5*x
}
