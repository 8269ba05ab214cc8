// mesh2 with normals: an octahedron shaded round, and two copies.
#version 3.7;
global_settings { assumed_gamma 1.0 }

camera { location <0, 2.5, -6> right x*4/3 look_at <0, 0.6, 0> angle 54 }
light_source { <-6, 9, -8>, rgb 1 }
plane { y, 0 pigment { checker rgb <0.75, 0.72, 0.65> rgb <0.35, 0.38, 0.42> } }

#declare Ball = mesh2 {
  vertex_vectors { 6, <1, 0, 0>, <-1, 0, 0>, <0, 1, 0>, <0, -1, 0>, <0, 0, 1>, <0, 0, -1> }
  normal_vectors { 6, <1, 0, 0>, <-1, 0, 0>, <0, 1, 0>, <0, -1, 0>, <0, 0, 1>, <0, 0, -1> }
  face_indices { 8, <0, 2, 5>, <0, 2, 4>, <0, 3, 5>, <0, 3, 4>, <1, 2, 5>, <1, 2, 4>, <1, 3, 5>, <1, 3, 4> }
  inside_vector <0.2, 1, 0.1>
}
object { Ball rotate y*20 translate y pigment { rgb <0.85, 0.35, 0.2> } finish { specular 0.4 roughness 0.03 } }
object { Ball scale 0.5 rotate <30, 10, 40> translate <-2, 0.6, -0.4> pigment { rgb <0.2, 0.5, 0.85> } }
intersection { object { Ball scale 0.8 } box { <-1, -1, -1>, <1, 0.3, 0.2> } translate <2, 0.8, 0> pigment { rgb <0.3, 0.75, 0.35> } }
