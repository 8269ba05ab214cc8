// Things made by loops, macros, arrays, splines, functions.
#version 3.7;
global_settings { assumed_gamma 1 }
#include "shared.inc"
#macro Ball(P, R)
    sphere { P, R
#end
#declare Path = spline { cubic_spline -1, <0, 0, 0>, 0, <0, 0, 0>, 1, <1, 2, 0>, 2, <2, 0, 0>, 3, <2, 0, 0> }
#declare Height = function (a, b) { sin(a)*cos(b) }
#declare Radii = array[3] { .1, .2, .3 }
#for (I, 0, 2)
    Ball(Path(I/2), Radii[I]) pigment { rgb Half*I } }
#end
#declare N = 0;
#while (N < 2)
    union {
        #local J = 0;
        #while (J < 2)
            box { <N, Height(N, J), J>, <N, Height(N, J), J> + .5 }
            #local J = J + 1;
        #end
        #if (N = 1) translate y #else rotate 10*x #end
    }
    #declare N = N + 1;
#end
#declare Thing = object { Ball(0, 1) } scale 2 }
object { Thing translate x }
Thing
#switch (N)
    #case (1) sphere { 0, 100 } #break
    #range (2, 3) cylinder { 0, y, .25 open } #break
    #else sphere { 0, 200 }
#end
#debug concat("N is ", str(N, 0, 0), "\n")
