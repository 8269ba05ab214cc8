// Polygons: with a hole, two apart, one that crosses itself, one not closed, in space, two-sided.
#version 3.7;
global_settings { assumed_gamma 1.0 }

camera { location <0, 2.5, -6> right x*4/3 look_at <0, 0.9, 0> angle 54 }
light_source { <-6, 9, -8>, rgb 1 }
plane { y, 0 pigment { checker rgb <0.75, 0.72, 0.65> rgb <0.35, 0.38, 0.42> } }

polygon { 10, <-0.8, -0.8>, <0.8, -0.8>, <0.9, 0.8>, <-0.8, 0.9>, <-0.8, -0.8>,
          <-0.4, -0.4>, <0.4, -0.4>, <0.2, 0.4>, <-0.4, 0.3>, <-0.4, -0.4>
          rotate y*30 translate <-2, 1.1, 0> pigment { rgb <0.85, 0.35, 0.2> } }
polygon { 6, <0, 1>, <0.59, -0.81>, <-0.95, 0.31>, <0.95, 0.31>, <-0.59, -0.81>, <0, 1>
          rotate x*-20 translate <0.1, 1.2, 0> pigment { rgb <0.2, 0.5, 0.85> } }
polygon { 8, <1.4, 0.1, 0>, <2.6, 0.1, -0.5>, <2, 0.9, -0.25>, <1.4, 0.1, 0>, <1.4, 1.0, 0>, <2.6, 1.0, -0.5>, <2.2, 1.8, -0.33333333333333333>, <1.4, 1.0, 0>
          pigment { rgb <0.3, 0.75, 0.35> } interior_texture { pigment { rgb <0.9, 0.8, 0.2> } } }
polygon { 4, <-1, 0.4, -2>, <0.5, 0.2, -2.5>, <0.6, 0.3, -1.5>, <-0.9, 0.5, -1>  pigment { rgb <0.7, 0.3, 0.7> } }
polygon { 4, <-1, 0, -1>, <0.5, 0, -1>, <0.6, 0, -0.4>, <-0.9, 0, -0.3> translate y*0.3 pigment { rgb <0.7, 0.7, 0.2> } }
