// Without a version: 3.62 rules.
#declare Base = camera { location <1, 2, 3> sky z look_at <1, 5, 3> right -4/3*x }
camera { Base rotate 10*y translate x }
fog { rgb <.8, .8, .9> distance 50 fog_type 2 fog_offset 1 fog_alt 3 rotate 90*x }
sky_sphere { pigment { gradient y color_map { [0 rgb 1] [1 rgb <0, 0, 1>] } scale 2 translate -1 } }
merge { sphere { 0, 1 } sphere { x, 1 } bounded_by { box { -1, 2 } } clipped_by { plane { y, 0 } } }
intersection { box { -1, 1 } cone { 0, 1, y, .5 } cutaway_textures }
