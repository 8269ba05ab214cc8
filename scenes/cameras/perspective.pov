// The default camera, only moved: right is 1.33, direction is z.
#version 3.7;
global_settings { assumed_gamma 1.0 }

camera { location <0, 1.5, -5> }
light_source { <-6, 9, -8>, rgb 1 }
plane { y, 0 pigment { checker rgb <0.75, 0.72, 0.65> rgb <0.35, 0.38, 0.42> } }
#declare I = 0;
#while (I < 5)
  box { <-0.3, 0, -0.3>, <0.3, 0.4 + 0.3*I, 0.3> translate <1.1*(I - 2), 0, 0.8*(I - 2)> pigment { rgb <0.9 - 0.15*I, 0.3, 0.2 + 0.15*I> } }
  #declare I = I + 1;
#end
