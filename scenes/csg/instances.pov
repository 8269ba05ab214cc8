// Copies of declared compounds: nested, mirrored, scaled; a glass child, a difference, and textures that the copy gives.
#version 3.7;
global_settings { assumed_gamma 1.0 max_trace_level 8 }

camera { location <0, 4, -11> right x*4/3 look_at <0, 1.2, 0> angle 44 }
light_source { <-6, 10, -9>, rgb 1 }
plane { y, 0 pigment { checker rgb <0.8, 0.78, 0.7> rgb <0.4, 0.45, 0.5> } }

#declare Cup = difference {
  cylinder { 0, 0.5*y, 0.3 }
  sphere { 0.5*y, 0.25 pigment { rgb <0.9, 0.8, 0.2> } }
}
#declare Branch = union {
  cylinder { -0.03*y, 1.17*y, 0.1 pigment { gradient y color_map { [0 rgb <0.5, 0.25, 0.1>] [1 rgb <0.9, 0.8, 0.6>] } scale 0.4 } }
  object { Cup translate 1.1*y }
  sphere { <0.35, 0.6, 0>, 0.25 pigment { rgbt <0.9, 1, 0.95, 0.8> } finish { reflection 0.1 } interior { ior 1.3 } }
  torus { 0.25, 0.07 translate 0.2*y }
}
#declare Tree = union {
  object { Branch }
  object { Branch rotate 50*z translate 0.8*y }
  object { Branch scale <-0.8, 1, 0.8> rotate -40*z translate 0.5*y }
  sphere { 0, 0.35 }
  pigment { bozo color_map { [0.3 rgb <0.2, 0.6, 0.2>] [0.7 rgb <0.8, 0.9, 0.3>] } scale 0.2 }
}

object { Tree translate <-2.8, 0.2, 0> }
object { Tree scale <-1, 1.3, 1> translate <0, 0.2, 1.2> }
object { Tree rotate -35*y scale 0.8 translate <2.9, 0.2, 0> no_shadow }
object { Branch translate <-1.4, 0, -1.8> pigment { rgb <0.9, 0.4, 0.1> } finish { reflection 0.2 } }
object { Branch scale 0.8 translate <1.2, 0, -1.8> pigment { rgbt <0.4, 0.5, 0.9, 0.5> } interior { ior 1.1 } }
