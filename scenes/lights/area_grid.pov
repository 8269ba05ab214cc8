// An area light without jitter: the grid is the reference's own, so the picture is equal.
#version 3.7;
global_settings { assumed_gamma 1.0 }

camera { location <0, 2.5, -6> right x*4/3 look_at <0, 0.6, 0> angle 54 }
plane { y, 0 pigment { rgb <0.8, 0.8, 0.75> } finish { ambient 0.05 } }
sphere { <-1.3, 0.8, 0>, 0.8 pigment { rgb 0.8 } }
box { <-0.5, 0, -0.5>, <0.5, 1.2, 0.5> rotate y*30 translate <1.2, 0, 0.2> pigment { rgb 0.8 } }

light_source { <-4, 6, -4>, rgb 1 area_light <2, 0, 0>, <0, 0, 2>, 5, 5 }
