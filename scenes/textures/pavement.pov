// pavement: tiles of triangles, squares and hexagons, with all forms of corners, and as a normal.
#version 3.7;
global_settings { assumed_gamma 1.0 }

camera { orthographic location <0, 0, -5> right x*6 up y*4 look_at 0 }
light_source { <-30, 40, -100>, rgb 1 }
#default { finish { ambient 0.4 diffuse 0.6 } }
#macro Panel(Column, Row, Sides, Tiles, Number, Exterior, Interior, Form)
    box { <-0.48, -0.48, 0>, <0.48, 0.48, 0.1>
        pigment {
            pavement number_of_sides Sides number_of_tiles Tiles pattern Number exterior Exterior interior Interior form Form
            color_map { [0 rgb <0.8, 0.7, 0.5>] [0.7 rgb <0.7, 0.4, 0.2>] [0.9 rgb <0.3, 0.2, 0.2>] [1 rgb 0.05] }
            rotate -x*90 scale 0.14 rotate z*4
        }
        translate <Column - 2.5, 1.5 - Row, 0>
    }
#end
Panel(0, 0, 3, 1, 1, 0, 0, 0)
Panel(1, 0, 3, 3, 1, 1, 1, 1)
Panel(2, 0, 3, 4, 2, 2, 2, 2)
Panel(3, 0, 3, 5, 3, 2, 0, 1)
Panel(4, 0, 3, 6, 7, 0, 2, 2)
Panel(5, 0, 3, 6, 12, 1, 2, 0)
Panel(0, 1, 4, 1, 1, 2, 0, 0)
Panel(1, 1, 4, 3, 2, 1, 1, 1)
Panel(2, 1, 4, 4, 3, 2, 2, 2)
Panel(3, 1, 4, 5, 12, 0, 1, 3)
Panel(4, 1, 4, 6, 16, 2, 2, 0)
Panel(5, 1, 4, 6, 35, 1, 0, 2)
Panel(0, 2, 6, 1, 1, 0, 0, 0)
Panel(1, 2, 6, 2, 1, 0, 1, 1)
Panel(2, 2, 6, 3, 2, 0, 2, 2)
Panel(3, 2, 6, 4, 7, 0, 0, 1)
Panel(4, 2, 6, 5, 8, 0, 1, 2)
Panel(5, 2, 6, 5, 22, 0, 2, 0)
#declare Bumpy = pigment { rgb <0.6, 0.65, 0.7> }
box { <-2.98, -1.98, 0>, <-1.02, -1.02, 0.1> pigment { Bumpy } normal { pavement -0.4 number_of_sides 4 number_of_tiles 5 pattern 6 rotate -x*90 scale 0.17 } }
box { <-0.98, -1.98, 0>, <0.98, -1.02, 0.1> pigment { Bumpy } normal { pavement -0.4 number_of_sides 6 number_of_tiles 3 pattern 2 form 2 rotate -x*90 scale 0.17 } }
box { <1.02, -1.98, 0>, <2.98, -1.02, 0.1> pigment { Bumpy } normal { tiling 16 -0.5 rotate -x*90 scale 0.17 } }
