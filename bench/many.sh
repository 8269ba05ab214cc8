#!/usr/bin/env bash
# CPU time of renderboy against povray where one thing has many parts: members of a compound, components of a blob,
# points of an outline, lights, ... Scenes are made here; bench/samples.sh times them. Needs povray.
# usage: bench/many.sh [-n RUNS] [-b RENDERBOY] [SWITCHES ...]
set -euo pipefail
here=$(cd "$(dirname "$0")" && pwd)
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
head='#version 3.7; global_settings { assumed_gamma 1 } #declare R = seed(3);
camera { location <0, 0, -12> look_at 0 angle 50 } light_source { <5, 8, -10>, 1 } #default { pigment { rgb 1 } }'

# scene NAME COUNT BEFORE EACH AFTER: EACH is repeated; I counts from 0, N is COUNT
scene() {
    printf '%s\n#declare N = %d;\n%s\n#declare I = 0; #while (I < N) %s #declare I = I + 1; #end\n%s\n' \
        "$head" "$2" "$3" "$4" "$5" > "$work/$1.pov"
    echo "$1" >> "$work/list"
}
place='<rand(R)*8 - 4, rand(R)*8 - 4, rand(R)*2>'
star='<(3 + sin(I*1.3))*cos(2*pi*I/N), (3 + sin(I*1.3))*sin(2*pi*I/N)>,'
scene difference_1000 1000 'difference { box { -4, 4 }' 'sphere { <rand(R)*8 - 4, rand(R)*8 - 4, rand(R)*.3 - 4>, 0.2 }' '}'
scene merge_1000 1000 'merge {' "sphere { $place, 0.4 }" 'pigment { rgbt <1, 1, 1, .5> } }'
scene intersection_500 500 'intersection { box { -3, 3 } merge {' "sphere { $place - 4*z, 0.3 }" '} }'
scene union_20000 20000 'union {' "sphere { $place, 0.2 pigment { rgb rand(R) } }" '}'
scene blob_200 200 'blob { threshold 0.5' 'sphere { <rand(R)*10 - 5, rand(R)*7 - 3.5, rand(R)*6 - 3>, 0.8, 1 }' '}'
scene blob_2000 2000 'blob { threshold 0.5' 'sphere { <rand(R)*10 - 5, rand(R)*7 - 3.5, rand(R)*6 - 3>, 0.8, 1 }' '}'
scene polygon_2000 2000 'polygon { N + 1,' "$star" '<3, 0> }'
scene prism_2000 2000 'prism { linear_spline -1, 1, N + 1,' "$star" '<3, 0> rotate <-90, 30, 0> }'
scene lathe_300 300 'lathe { cubic_spline N + 2, <0.1, -3.1>,' '<1.5 + sin(I*1.3)*.5, 6*I/N - 3>,' '<0.1, 3.2> }'
scene sphere_sweep_300 300 'sphere_sweep { cubic_spline N,' '<3*cos(6*pi*I/N), 3*sin(6*pi*I/N), sin(I)*.3>, .1' '}'
scene text_2000 2000 '' "text { ttf \"timrom.ttf\" \"Hello\" .2, 0 scale .3 translate $place }" ''
scene isosurface_400 400 'union {' "isosurface { function { x*x + y*y + z*z*z*z - .1 } contained_by { box { -.5, .5 } } translate $place }" '}'
scene lights_300 300 'plane { z, 2 } sphere { 0, 2 }' 'light_source { <rand(R)*20 - 10, rand(R)*20 - 10, -5> rgb 2/N }' ''
options=()
while getopts n:b: option; do options+=("-$option" "$OPTARG"); done
shift $((OPTIND - 1))
[ $# -eq 0 ] && set -- +W320 +H240 -A +WT1
EXAMPLES=$work "$here/samples.sh" "${options[@]}" -l "$work/list" "$@"
