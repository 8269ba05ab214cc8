// Smooth triangles: interpolated normals round a pyramid.
#version 3.7;
global_settings { assumed_gamma 1.0 }

camera { location <0, 2.5, -6> right x*4/3 look_at <0, 0.6, 0> angle 54 }
light_source { <-6, 9, -8>, rgb 1 }
plane { y, 0 pigment { checker rgb <0.75, 0.72, 0.65> rgb <0.35, 0.38, 0.42> } }

#declare Top = <0, 2, 0>;
#declare I = 0;
#while (I < 6)
  #declare A = vrotate(<1.2, 0.2, 0>, y*60*I);
  #declare B = vrotate(<1.2, 0.2, 0>, y*60*(I + 1));
  smooth_triangle { Top, y, A, A - y*0.2, B, B - y*0.2 pigment { rgb <0.85, 0.35, 0.2> } finish { specular 0.4 roughness 0.03 } }
  #declare I = I + 1;
#end
