// tiling 1 to 27.
#version 3.7;
global_settings { assumed_gamma 1.0 }

camera { orthographic location <0, 0, -5> right x*7 up y*5.2 look_at 0 }
#default { finish { ambient 1 diffuse 0 } }
#declare N = 0;
#while (N < 27)
    #declare Column = mod(N, 7);
    #declare Row = int(N / 7);
    box { <-0.48, -0.62, 0>, <0.48, 0.62, 0.1>
        pigment {
            tiling N + 1
            color_map { [0 rgb <0.1, 0.3, 0.5>] [0.33 rgb <0.3, 0.8, 0.6>] [0.5 rgb <0.7, 0.3, 0.2>] [0.5 rgb <0.9, 0.8, 0.3>] [0.8 rgb <0.5, 0.2, 0.6>] [1 rgb 1] }
            rotate -x*90
            scale 0.23
            rotate z*3
            translate <0.013, 0.007, 0>
        }
        translate <Column - 3, 1.95 - 1.3 * Row, 0>
    }
    #declare N = N + 1;
#end
