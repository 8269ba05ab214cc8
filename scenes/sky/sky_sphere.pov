// sky_sphere with a gradient and clouds in two layers.
#version 3.7;
global_settings { assumed_gamma 1.0 }

camera { location <0, 1, -5> right x*4/3 look_at <0, 2, 0> angle 70 }
light_source { <-6, 9, -8>, rgb 1 }
plane { y, 0 pigment { checker rgb <0.75, 0.72, 0.65> rgb <0.35, 0.38, 0.42> } }

sky_sphere {
  pigment { gradient y color_map { [0 rgb <0.8, 0.85, 0.9>] [0.6 rgb <0.1, 0.25, 0.6>] } }
  pigment { bozo turbulence 0.6 color_map { [0.4 rgbt 1] [0.7 rgb 0.95] } scale <0.6, 0.2, 0.6> }
}
sphere { <1, 1, 0>, 0.8 pigment { rgb 0.1 } finish { reflection 0.7 } }
