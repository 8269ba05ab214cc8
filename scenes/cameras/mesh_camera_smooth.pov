// The same with interpolated normals, seen from a little behind the mesh.
#version 3.7;
global_settings { assumed_gamma 1 }

#declare Screen = mesh2 {
  vertex_vectors { 4, <-2, -1, -5>, <2, -1, -5.3>, <-2, 2, -5>, <2, 2, -4.6> }
  normal_vectors { 4, <.3, .2, -1>, <-.3, .2, -1>, <.3, -.2, -1>, <-.3, -.2, -1> }
  uv_vectors { 4, <.05, .02>, <.95, .1>, <0, 1>, <1, .9> }
  face_indices { 2, <0, 1, 2>, <1, 3, 2> }
}

camera { mesh_camera { 1 3 mesh { Screen scale <1, 1.1, 1> rotate 2*x } smooth } location <0, 0, .4> direction -z }

light_source { <-6, 9, -5> rgb 1 }
plane { y, -1 pigment { checker rgb <.8, .75, .6> rgb <.3, .4, .45> } finish { ambient .2 } }
sphere { <0, 0, 3>, 1 pigment { rgb <.9, .3, .2> } finish { ambient .2 phong .6 } }
box { <1.5, -1, 1>, <2.5, 2, 2> pigment { rgb <.3, .7, .3> } finish { ambient .2 } }
cylinder { <-2.5, -1, 2>, <-2.5, 1.5, 2>, .6 pigment { rgb <.3, .4, .9> } finish { ambient .2 } }
cone { <-.5, -1, -3>, .8, <-.5, 1, -3>, 0 pigment { rgb <.8, .7, .2> } finish { ambient .2 } }
background { rgb <.4, .55, .8> }
