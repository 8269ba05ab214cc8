// Nested compounds: a die with pips, a rounded frame.
#version 3.7;
global_settings { assumed_gamma 1.0 }

camera { location <0, 2.5, -6> right x*4/3 look_at <0, 0.6, 0> angle 54 }
light_source { <-6, 9, -8>, rgb 1 }
plane { y, 0 pigment { checker rgb <0.75, 0.72, 0.65> rgb <0.35, 0.38, 0.42> } }

#declare Pip = sphere { 0, 0.16 }
#declare Die = difference {
  intersection { box { -0.8, 0.8 } sphere { 0, 1.15 } }
  union {
    object { Pip translate <0, 0.8, 0> }
    union { object { Pip translate <-0.4, 0.4, -0.8> } object { Pip translate <0.4, -0.4, -0.8> } object { Pip translate <0, 0, -0.8> } }
    union { object { Pip translate <-0.8, 0.4, 0.4> } object { Pip translate <-0.8, -0.4, -0.4> } }
    pigment { rgb 0.1 }
  }
}
object { Die rotate y*30 translate <-0.9, 0.8, 0> pigment { rgb <0.85, 0.35, 0.2> } finish { specular 0.4 roughness 0.03 } }
object { Die rotate <90, 0, 15> scale 0.7 translate <1.3, 0.56, -0.3> pigment { rgb <0.9, 0.75, 0.3> } }
