// fade_distance, fade_power and fade_color inside glass.
#version 3.7;
global_settings { assumed_gamma 1.0 }

camera { location <0, 2.5, -6> right x*4/3 look_at <0, 0.6, 0> angle 54 }
light_source { <-6, 9, -8>, rgb 1 }
plane { y, 0 pigment { checker rgb <0.75, 0.72, 0.65> rgb <0.35, 0.38, 0.42> } }

#declare Clear = texture { pigment { rgbt 1 } finish { ambient 0 diffuse 0 specular 0.5 } }
sphere { <-1.5, 0.9, 0>, 0.8 texture { Clear } interior { ior 1.2 fade_distance 0.6 fade_power 2 fade_color rgb <0.9, 0.3, 0.2> } }
box { <-0.7, 0.01, -0.7>, <0.7, 1.2, 0.7> translate x*1.3 texture { Clear } interior { ior 1.1 fade_distance 0.5 fade_power 1001 fade_color rgb <0.2, 0.7, 0.9> } }
