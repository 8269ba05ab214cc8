// uv_mapping written in the texture: plain, with a normal, of an identifier, patterned, moved by texture and object, and in a normal of an entry
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 3, -9> look_at <0, 0, 0> angle 50 }
light_source { <6, 12, -12>, rgb 1 }
background { rgb 0.2 }

#declare Squares = texture { pigment { checker rgb <0.9, 0.6, 0.2>, rgb <0.1, 0.2, 0.5> scale 0.125 } }
#declare Layered =
  texture { Squares }
  texture { pigment { gradient x color_map { [0.5 rgbt 1] [0.5 rgb <0.8, 0.1, 0.1>] } scale 0.25 } }

sphere {
  0, 1
  texture { uv_mapping pigment { brick rgb 0.9, rgb <0.6, 0.2, 0.1> brick_size <0.2, 0.1, 1> mortar 0.02 } }
  rotate 30 * z translate <-2.4, 1.2, 0>
}
sphere {
  0, 1
  texture { uv_mapping pigment { rgb <0.7, 0.8, 0.6> } normal { bumps 0.8 scale 0.1 } finish { phong 0.6 } }
  rotate 40 * z scale <1, 0.8, 1> translate <0, 1.2, 0>
}
box { -0.9, 0.9 texture { uv_mapping Squares scale 0.6 } rotate 35 * y translate <2.4, 1.2, 0> }
torus { 0.8, 0.35 texture { uv_mapping Layered translate 0.05 * x } rotate -40 * x translate <-2.4, -1.2, 0> }
cylinder { -0.9 * y, 0.9 * y, 0.8 texture { uv_mapping Squares } rotate <-20, 0, 20> translate <0, -1.2, 0> }
box {
  -0.9, 0.9
  texture {
    uv_mapping gradient x texture_map { [0.4 Squares] [0.6 pigment { rgb <0.3, 0.7, 0.3> } normal { uv_mapping bumps 0.9 scale 0.1 }] }
    scale 0.5
  }
  rotate <20, -30, 0> translate <2.4, -1.2, 0>
}
