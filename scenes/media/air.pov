// Media in the air: cones of spotlights and a cylinder of light, with shadows in them, before fog.
#version 3.7;
global_settings { assumed_gamma 1.0 }
camera { location <0, 2, -12> look_at <0, 2, 0> angle 44 }
media { scattering { 1, 0.06 extinction 0.5 } intervals 3 density { gradient y scale 8 translate -2 * y } }
media { absorption <0.01, 0.02, 0.03> }
fog { distance 60 rgb <0.25, 0.3, 0.4> }
light_source { <-4, 6, 0> rgb <1, 0.8, 0.5> spotlight point_at <-2, 0, 0> radius 14 falloff 20 media_attenuation on }
light_source { <5, 6, -1> rgb <0.4, 0.7, 1> cylinder point_at <2.5, 0, 1> radius 0.8 falloff 1.2 }
light_source { <0, 20, -20> rgb 0.4 media_interaction off }
sphere { <-2.8, 3, 0>, 0.6 pigment { rgb 0.8 } }
box { <2.5, 2, -1>, <3.6, 2.2, 0.4> pigment { rgb <0.8, 0.5, 0.4> } }
sphere { <0, 1, 0>, 1 pigment { rgb 0.9 } finish { reflection 0.4 } }
plane { y, 0 pigment { rgb 0.6 } }
