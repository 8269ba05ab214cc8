// A still life: glass, metal, stone and soft shadows.
// options: +A0.3
// tolerance: 0.02 the jittered light is random in the reference
#version 3.7;
global_settings { assumed_gamma 1.0 }

camera { location <0, 3.2, -8> right x*4/3 look_at <0, 1.1, 0> angle 40 }
light_source { <-7, 9, -6>, rgb <1, 0.95, 0.85> area_light <3, 0, 0>, <0, 0, 3>, 9, 9 adaptive 1 jitter }
light_source { <8, 5, -9>, rgb <0.22, 0.25, 0.32> shadowless }
sky_sphere { pigment { gradient y color_map { [0 rgb <0.75, 0.8, 0.85>] [1 rgb <0.2, 0.35, 0.65>] } } }
plane { y, 0 pigment { checker pigment { marble turbulence 0.7 color_map { [0 rgb <0.9, 0.88, 0.84>] [0.7 rgb <0.8, 0.77, 0.72>] [1 rgb <0.5, 0.46, 0.44>] } scale 0.7 } pigment { granite color_map { [0 rgb <0.2, 0.22, 0.26>] [1 rgb <0.42, 0.42, 0.45>] } scale 0.8 } scale 1.2 } finish { reflection { 0.03, 0.3 } } }
sphere { <-1.9, 1, 0.4>, 1 pigment { rgbt <0.97, 1, 0.98, 0.96> } finish { specular 0.8 roughness 0.005 reflection { 0.02, 1 fresnel } conserve_energy } interior { ior 1.5 fade_distance 3 fade_power 1001 fade_color rgb <0.5, 0.9, 0.8> } }
torus { 0.75, 0.28 rotate x*72 rotate y*-25 translate <1.9, 1.0, 0.1> pigment { rgb <0.95, 0.72, 0.35> } finish { ambient 0.05 diffuse 0.35 specular 0.8 roughness 0.02 metallic reflection { 0.45 metallic } } }
difference { box { -0.8, 0.8 } sphere { 0, 1.02 } cylinder { -2*x, 2*x, 0.35 } rotate y*32 translate <0.15, 0.8, 1.6> pigment { rgb <0.62, 0.16, 0.12> } finish { phong 0.4 } }
cone { <0.35, 0, -1.6>, 0.42, <0.35, 1.05, -1.6>, 0 pigment { gradient y triangle_wave color_map { [0 rgb <0.1, 0.3, 0.55>] [1 rgb <0.7, 0.85, 0.95>] } scale 0.18 } finish { phong 0.5 } }
#for (I, 0, 6)
  sphere { <-0.9 + 0.28*I, 0.12, -2.4 + 0.05*mod(I, 3)>, 0.12 pigment { rgb <0.85 - 0.1*I, 0.3 + 0.05*I, 0.15 + 0.1*I> } finish { specular 0.6 roughness 0.01 } }
#end
