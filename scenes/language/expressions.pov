// Vector and float functions place spheres along curves.
#version 3.7;
global_settings { assumed_gamma 1.0 }

camera { location <0, 2.5, -6> right x*4/3 look_at <0, 0.6, 0> angle 54 }
light_source { <-6, 9, -8>, rgb 1 }
plane { y, 0 pigment { checker rgb <0.75, 0.72, 0.65> rgb <0.35, 0.38, 0.42> } }

#declare I = 0;
#while (I < 24)
  #declare A = radians(15*I);
  #declare P = <1.8*cos(A), 1 + 0.6*sin(3*A), 1.2*sin(A)>;
  sphere { P, 0.08 + 0.1*abs(sin(A*2)) pigment { rgb <(I < 12 ? 0.9 : 0.2), vlength(P)/3, vdot(vnormalize(P), y)> } }
  #declare I = I + 1;
#end
cylinder { 0, vcross(x, -z)*1.2, 0.1 pigment { rgb select(-1, 0.8, 0.1) } }
