// Macros: values, by reference, recursion, objects.
#version 3.7;
global_settings { assumed_gamma 1.0 }

camera { location <0, 2.5, -6> right x*4/3 look_at <0, 0.6, 0> angle 54 }
light_source { <-6, 9, -8>, rgb 1 }
plane { y, 0 pigment { checker rgb <0.75, 0.72, 0.65> rgb <0.35, 0.38, 0.42> } }

#macro Twig(P, D, L, N)
  cylinder { P, P + D*L, 0.03 + 0.02*N pigment { rgb <0.5, 0.35, 0.2> } }
  #if (N > 0)
    Twig(P + D*L, vnormalize(vrotate(D, <18, 0, 25>)), L*0.75, N - 1)
    Twig(P + D*L, vnormalize(vrotate(D, <-15, 0, -28>)), L*0.7, N - 1)
  #else
    sphere { P + D*L, 0.13 pigment { rgb <0.25, 0.6, 0.25> } }
  #end
#end
#macro Grow(Size) #declare Size = Size + 0.25; #end
#declare S = 0.5;
Grow(S)
Twig(<0, 0, 0>, y, S, 5)
