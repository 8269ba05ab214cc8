// A mesh of flat and smooth triangles made by a loop; shadows on itself.
#version 3.7;
global_settings { assumed_gamma 1.0 }

camera { location <0, 2.5, -6> right x*4/3 look_at <0, 0.6, 0> angle 54 }
light_source { <-6, 9, -8>, rgb 1 }
plane { y, 0 pigment { checker rgb <0.75, 0.72, 0.65> rgb <0.35, 0.38, 0.42> } }

#declare Wave = function(a, b) { 0.35*sin(3*a)*cos(3*b) }
#macro Corner(A, B) <A, 0.9 + Wave(A, B), B> #end
#declare N = 16;
#declare Sheet = mesh {
  #declare I = 0;
  #while (I < N)
    #declare J = 0;
    #while (J < N)
      #declare A = -1.6 + 3.2*I/N;  #declare B = -1.6 + 3.2*J/N;  #declare D = 3.2/N;
      triangle { Corner(A, B), Corner(A + D, B), Corner(A + D, B + D) }
      triangle { Corner(A, B), Corner(A + D, B + D), Corner(A, B + D) }
      #declare J = J + 1;
    #end
    #declare I = I + 1;
  #end
}
object { Sheet rotate x*-12 pigment { rgb <0.85, 0.35, 0.2> } finish { specular 0.4 roughness 0.03 } }
