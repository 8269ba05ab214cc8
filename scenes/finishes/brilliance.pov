// brilliance, with and without albedo.
#version 3.7;
global_settings { assumed_gamma 1.0 }

camera { location <0, 2.5, -6> right x*4/3 look_at <0, 0.6, 0> angle 54 }
light_source { <-6, 9, -8>, rgb 1 }
plane { y, 0 pigment { checker rgb <0.75, 0.72, 0.65> rgb <0.35, 0.38, 0.42> } }
sphere { <-2.3, 0.75, 0>, 0.62 pigment { rgb <0.75, 0.5, 0.3> } finish { brilliance 0.3 } }
sphere { <-0.767, 0.75, 0>, 0.62 pigment { rgb <0.75, 0.5, 0.3> } finish { brilliance 1 } }
sphere { <0.767, 0.75, 0>, 0.62 pigment { rgb <0.75, 0.5, 0.3> } finish { brilliance 3 } }
sphere { <2.3, 0.75, 0>, 0.62 pigment { rgb <0.75, 0.5, 0.3> } finish { diffuse albedo 0.6 brilliance 6 } }
