// Superellipsoids from box-like to star-like, moved and stretched.
#version 3.7;
global_settings { assumed_gamma 1.0 }

camera { location <0, 3.5, -8> right x*4/3 look_at <0, 0.9, 0> angle 48 }
light_source { <-6, 9, -8>, rgb 1 }
plane { y, 0 pigment { checker rgb <0.75, 0.72, 0.65> rgb <0.35, 0.38, 0.42> } }

superellipsoid { <0.25, 0.25> rotate <20, 40, 10> translate <-2.5, 1.4, 0.5> pigment { rgb <0.85, 0.35, 0.2> } }
superellipsoid { <1, 0.3> rotate x*60 translate <0, 1.3, 0.6> pigment { rgb <0.2, 0.5, 0.85> } finish { specular 0.4 } }
superellipsoid { <0.2, 2> scale <1, 1, 1.3> rotate <70, 20, 0> translate <2.5, 1.2, 0.4> pigment { rgb <0.3, 0.75, 0.35> } }
superellipsoid { <2.8, 2.5> rotate <30, 30, 0> translate <-1.2, 0.9, -2> pigment { rgb <0.8, 0.75, 0.3> } }
superellipsoid { <0.7, 1.6> scale 0.7 rotate <-30, 20, 0> translate <1.2, 0.8, -2> pigment { rgb <0.6, 0.4, 0.8> } }
