// #while, #for, #switch, arrays, rand.
#version 3.7;
global_settings { assumed_gamma 1.0 }

camera { location <0, 2.5, -6> right x*4/3 look_at <0, 0.6, 0> angle 54 }
light_source { <-6, 9, -8>, rgb 1 }
plane { y, 0 pigment { checker rgb <0.75, 0.72, 0.65> rgb <0.35, 0.38, 0.42> } }

#declare Tint = array[3] { rgb <0.85, 0.35, 0.2>, rgb <0.2, 0.5, 0.85>, rgb <0.3, 0.75, 0.35> }
#declare R = seed(42);
#for (I, -3, 3)
  #for (J, -1, 1)
    #switch (mod(I + J + 6, 3))
      #case (0) sphere { <I*0.8, 0.3, J*0.9>, 0.25 + 0.1*rand(R) pigment { Tint[0] } } #break
      #case (1) box { -0.25, 0.25 rotate y*90*rand(R) translate <I*0.8, 0.25, J*0.9> pigment { Tint[1] } } #break
      #else cone { <I*0.8, 0, J*0.9>, 0.3, <I*0.8, 0.5 + 0.5*rand(R), J*0.9>, 0 pigment { Tint[2] } }
    #end
  #end
#end
