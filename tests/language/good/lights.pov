#version 3.7;
global_settings { assumed_gamma srgb }
camera { orthographic location -z*4 look_at 0 right 4*x up 3*y }
light_source { <1, 2, 3>, <1, .5, .25> spotlight point_at y radius 10 falloff 20 tightness 5 fade_distance 4 fade_power 2 }
light_source { 0, srgb <.5, .5, .5> area_light x, y, 4, 5 adaptive 1 jitter circular orient translate 5*z }
light_source { <0, 5, 0> color rgb 1 parallel point_at 0 shadowless }
light_source { <0, 5, 0> rgb 1 looks_like { sphere { 0, .1 pigment { rgb 1 } finish { emission 1 } } } }
light_source { x, 1 cylinder radius 2 falloff 3 point_at -x media_interaction off rotate 90*y }
sphere { 0, 1 }
