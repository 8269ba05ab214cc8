#version 3.7;
global_settings { assumed_gamma 1 nonsense 2 } //! error: No matching } in 'global_settings', undeclared identifier 'nonsense' found instead
sphere { 0, 1 pigment { chekcer } } //! error: No matching } in 'pigment', undeclared identifier 'chekcer' found instead (did you mean 'checker'?)
sphere { 0, 1 texture { pigment { rgb 1 } finsh { } } } //! error: No matching } in 'texture', undeclared identifier 'finsh' found instead (did you mean 'finish'?)
box { <0, 0, 0> } //! error: Expected 'vector', } found instead
#declare Grey = rgb .5 plane { y, -2 } //! error: All #declares of float, vector, and color require semi-colon ';' at end if the language version is set to 3.5 or higher.
#declare Lamp = sphere { 0, Radius } //! error: Expected 'numeric expression', undeclared identifier 'Radius' found instead (did you mean 'radius'?)
object { Lamp }
plane { y, -1 pigment { Grey } }
triangle { 0, x, y photons { targt } } //! error: No matching } in 'photons', undeclared identifier 'targt' found instead (did you mean 'target'?)
camera { location x look_at x } //! error: Camera location and look_at point must be different.
camera { angle 180 } //! error: Viewing angle has to be smaller than 180 degrees.
sky_sphere { } //! error: Empty sky_sphere statement.
light_source { 0, rgb 1 area_light x, y, 0, 2 } //! error: Area size must be greater than zero.
sphere { 0, 1 interior_texture { pigment { rgb 1 } } } //! error: Interior texture requires an exterior texture.
sphere { 0, 1 pigment { rgb 1 } uv_mapping } //! error: uv_mapping must be specified before texture.
sphere { 0, 1 split_union off } //! error: Keyword 'split_union' cannot be used with this object.
#end //! error: Mis-matched '#end'.
