// Cuts without texture show what they cut: one thing, two at once (their mean), or nothing (black).
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <1, 4, -9> right 4/3*x look_at <0, 0, 0> angle 45 }
light_source { <-5, 8, -9> rgb 1 }
plane { y, -1.6 pigment { checker rgb .4 rgb .7 } finish { ambient .3 } }
#default { finish { ambient .3 } }

#declare Red = pigment { rgb <1, .3, .2> }
#declare Green = pigment { rgb <.2, .9, .3> }
difference {
  union {
    box { <-1, -1, -1>, <.3, 1, 1> pigment { Red } }
    box { <-.3, -1, -1>, <1, 1, 1> pigment { Green } }
  }
  sphere { <.3, 1, -1>, 1 }
  cylinder { <-.4, -.5, -2>, <-.4, -.5, 2>, .3 }
  cutaway_textures
  translate -2.2*x
}
intersection {
  box { -1, 1 pigment { checker rgb <1, .9, .4> rgb <.3, .4, 1> scale .4 } }
  difference { sphere { 0, 1.3 pigment { Green } } box { <-.3, -2, -2>, <.3, 2, 0> } }
  cylinder { -2*y, 2*y, 1.1 }
  cutaway_textures
  rotate 20*y
  translate .7*x
}
difference {
  box { <-.7, -1.5, -.7>, <.7, .8, .7> }
  sphere { <.2, .9, -.6>, .8 }
  cutaway_textures
  translate 3.2*x
}
