// tolerance: 0.06
// A field of 400 shapes of all colours under the sun and the sky.
#version 3.7;
#include "quality.inc"
camera { location <0, 4.5, -7.5> look_at <0, 0, -0.6> angle 45 }
sky_sphere { pigment { gradient y color_map { [0 rgb <0.6, 0.65, 0.7>] [1 rgb <0.3, 0.45, 0.8>] } } }
light_source { <40, 45, -25>, rgb <1.1, 1, 0.85> }
plane { y, 0 pigment { rgb 0.7 } }
#declare R = seed(7);
#for (I, -10, 9)
  #for (J, -10, 9)
    #local Size = 0.1 + 0.12*rand(R);
    #local Place = <I + 0.5 + 0.4*(rand(R) - 0.5), 0, J + 0.5 + 0.4*(rand(R) - 0.5)>*0.45;
    #if (mod(I + J + 20, 2) = 0)
      sphere { Place + Size*y, Size pigment { rgb <rand(R), rand(R), rand(R)> } }
    #else
      box { <-Size, 0, -Size>, <Size, Size*(1 + 2*rand(R)), Size> rotate 90*rand(R)*y translate Place
        pigment { rgb <rand(R), rand(R), rand(R)> } }
    #end
  #end
#end
