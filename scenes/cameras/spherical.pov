// All directions but the poles, tilted.
#version 3.7;
global_settings { assumed_gamma 1 }

camera { spherical angle 320, 140 location <0, .5, -1> right 4/3*x look_at <.3, .2, 3> }

light_source { <-6, 9, -5> rgb 1 }
plane { y, -1 pigment { checker rgb <.8, .75, .6> rgb <.3, .4, .45> } finish { ambient .2 } }
sphere { <0, 0, 3>, 1 pigment { rgb <.9, .3, .2> } finish { ambient .2 phong .6 } }
box { <1.5, -1, 1>, <2.5, 2, 2> pigment { rgb <.3, .7, .3> } finish { ambient .2 } }
cylinder { <-2.5, -1, 2>, <-2.5, 1.5, 2>, .6 pigment { rgb <.3, .4, .9> } finish { ambient .2 } }
cone { <-.5, -1, -3>, .8, <-.5, 1, -3>, 0 pigment { rgb <.8, .7, .2> } finish { ambient .2 } }
background { rgb <.4, .55, .8> }
