// Three meshes share the width of the picture.
// options: +W64 +H48
#version 3.7;
global_settings { assumed_gamma 1 }

#declare Columns = 21;
#declare Rows = 48;
#declare Grid = mesh {
  #declare J = 0;
  #while (J < Rows)
    #declare I = 0;
    #while (I < Columns)
      #declare A = <I / Columns * 4 - 2, 1.5 - J / Rows * 3, sin(I / 9) * .3>;
      triangle { A, A + <4 / Columns, 0, .002>, A - <0, 3 / Rows, .01> }
      #declare I = I + 1;
    #end
    #declare J = J + 1;
  #end
}

camera { mesh_camera { 1 2 mesh { Grid translate <0, .5, -5> } mesh { Grid rotate 10*x translate <0, 1, -5> } mesh { Grid rotate -9*y translate <0, .5, -5> } } }

light_source { <-6, 9, -5> rgb 1 }
plane { y, -1 pigment { checker rgb <.8, .75, .6> rgb <.3, .4, .45> } finish { ambient .2 } }
sphere { <0, 0, 3>, 1 pigment { rgb <.9, .3, .2> } finish { ambient .2 phong .6 } }
box { <1.5, -1, 1>, <2.5, 2, 2> pigment { rgb <.3, .7, .3> } finish { ambient .2 } }
cylinder { <-2.5, -1, 2>, <-2.5, 1.5, 2>, .6 pigment { rgb <.3, .4, .9> } finish { ambient .2 } }
cone { <-.5, -1, -3>, .8, <-.5, 1, -3>, 0 pigment { rgb <.8, .7, .2> } finish { ambient .2 } }
background { rgb <.4, .55, .8> }
