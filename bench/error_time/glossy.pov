// Mirrors roughened by bumps much smaller than a pixel.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 3, -8> look_at <0, 0.8, 0> angle 40 }
light_source { <5, 9, -8>, 1 }
background { rgb <0.4, 0.5, 0.7> }
plane { y, 0
  pigment { rgb 0.2 } normal { bumps 0.15 scale 0.003 } finish { reflection 0.6 diffuse 0.3 }
}
#for (I, -2, 2)
  sphere { <1.6*I, 0.8, 0>, 0.7 pigment { rgb <0.5 + 0.2*I, 0.4, 0.5 - 0.2*I> } finish { ambient 0.2 } }
#end
