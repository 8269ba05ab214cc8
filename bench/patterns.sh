#!/usr/bin/env bash
# Speed of patterns against povray: bench/samples.sh over scenes made here, both programs in turn. Needs povray.
# First a plane that fills the picture, with an average of copies of each pattern as pigment or normal: millions of evaluations a
# second, after the time of the same plane without a pattern. Then whole scenes: noise-heavy textures on a floor, two spheres
# and a box under one light.
# usage: bench/patterns.sh [-n RUNS] [-b RENDERBOY] [-o WORD]
# default: 3 runs; with -o only patterns and textures whose name contains WORD
set -euo pipefail
here=$(cd "$(dirname "$0")" && pwd)
runs=3
renderboy=$here/../build/release/renderboy
only=
while getopts n:b:o: option; do
    case $option in
        n) runs=$OPTARG ;;
        b) renderboy=$OPTARG ;;
        o) only=$OPTARG ;;
        *) exit 1 ;;
    esac
done
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
width=640
height=480
copies=8 # of the pattern in each pixel, averaged

# name, then a pattern; of normals with their amount
patterns() {
    local word generator
    for word in bozo granite wrinkles agate marble wood leopard onion dents ripples waves crackle cells checker brick hexagon \
        'gradient x' radial spherical cylindrical boxed planar quilted 'spiral1 5' 'spiral2 5'; do
        echo "${word// /_} $word"
    done
    for generator in 1 3; do
        for word in bozo granite wrinkles agate; do
            echo "$word,generator_$generator $word noise_generator $generator"
        done
    done
    for word in 1 3 6 10; do echo "bozo,turbulence,octaves_$word bozo turbulence 0.6 octaves $word"; done
    echo "bozo,warp bozo warp { turbulence 0.6 octaves 6 lambda 2.3 omega 0.6 }"
    for word in granite marble wood leopard; do echo "$word,turbulence $word turbulence 0.6"; done
    for word in bumps wrinkles dents granite bozo; do echo "normal,$word $word 0.5"; done
}

# name, then the texture, of which each object has its own scale
textures() {
    local word
    echo "one_colour pigment { rgb 0.5 }"
    echo "granite pigment { granite color_map { [0 rgb 0.2] [1 rgb 1] } }"
    echo "wrinkles pigment { wrinkles color_map { [0 rgb 0.2] [1 rgb 1] } }"
    echo "bozo,6_octaves pigment { bozo turbulence 0.8 octaves 6 color_map { [0 rgb <0.3, 0.4, 0.9>] [1 rgb 1] } }"
    echo "agate pigment { agate }"
    for word in T_Stone1 T_Stone8 T_Stone18 T_Stone24 T_Stone31 T_Stone44 T_Grnt9 T_Grnt25 T_Wood1 T_Wood7 T_Wood23; do
        echo "$word $word"
    done
}

# averaged WORD ENTRY: pigment or normal, the entry again and again in other places
averaged() {
    local i
    echo "$1 { average $1_map {"
    for i in $(seq "$copies"); do echo "[1 $2 translate <7.3, 3.1, 1.7> * $i]"; done
    echo "} }"
}
# plane_scene TEXTURE FINISH
plane_scene() {
    echo '#version 3.7; global_settings { assumed_gamma 1 }'
    echo 'camera { orthographic location -z*10 right x*16 up y*12 direction z }'
    echo 'light_source { -z*1000 rgb 1 shadowless }'
    echo "plane { -z, 0 texture { $1 finish { $2 } } }"
}
bright='ambient 1 diffuse 0'
lit='ambient 0 diffuse 1'
texture_scene() {
    local texture=$1
    [[ $texture == T_* ]] || texture="$texture finish { diffuse 0.8 specular 0.3 }"
    echo '#version 3.7; global_settings { assumed_gamma 1 }'
    echo '#include "colors.inc"'
    echo '#include "stones.inc"'
    echo '#include "woods.inc"'
    echo 'camera { location <0, 3, -9> look_at <0, 1, 0> angle 50 }'
    echo 'light_source { <-20, 40, -30> rgb 1 }'
    echo "#declare Worn = texture { $texture };"
    echo 'plane { y, 0 texture { Worn scale 2 } }'
    echo 'sphere { <-2.2, 1.5, 0>, 1.5 texture { Worn } }'
    echo 'sphere { <1.6, 1.2, -1>, 1.2 texture { Worn scale 0.5 } }'
    echo 'box { <0.2, 0, 2>, <2.6, 3, 3> texture { Worn scale 1.5 } }'
}

mkdir "$work/plane" "$work/texture"
plane_scene "$(averaged pigment 'rgb 0.5')" "$bright" > "$work/plane/plain_pigment.pov"
plane_scene 'pigment { rgb 0.5 }' "$lit" > "$work/plane/plain_normal.pov"
printf '%s\n' plain_pigment plain_normal > "$work/plane.list"
while read -r name what; do
    [[ $name == *"$only"* ]] || continue
    case $name in
        normal,*) plane_scene "pigment { rgb 0.5 } $(averaged normal "$what")" "$lit" ;;
        *) plane_scene "$(averaged pigment "$what")" "$bright" ;;
    esac > "$work/plane/$name.pov"
    echo "$name" >> "$work/plane.list"
done < <(patterns)
while read -r name what; do
    [[ $name == *"$only"* ]] || continue
    texture_scene "$what" > "$work/texture/$name.pov"
    echo "$name" >> "$work/texture.list"
done < <(textures)

EXAMPLES=$work/plane "$here/samples.sh" -n "$runs" -b "$renderboy" -l "$work/plane.list" \
    "+W$width" "+H$height" -A -F +WT1 > "$work/plane.table"
printf '%-28s %9s %10s %7s\n' 'million evaluations a second' povray renderboy ratio
awk -v points=$((width * height * copies)) '
    function rate(seconds) { return points / 1e6 / (seconds > 0.001 ? seconds : 0.001) }
    NR == 1 || /^geometric/ { next }
    /^plain_/ { theirs[$1] = $2; ours[$1] = $3; next }
    {
        base = $1 ~ /^normal/ ? "plain_normal" : "plain_pigment"
        a = rate($2 - theirs[base]); b = rate($3 - ours[base])
        printf "%-28s %9.2f %10.2f %7.2f\n", $1, a, b, b / a
        sum += log(b / a); ++count
    }
    END { if (count) printf "geometric mean %.2f\n", exp(sum / count) }' "$work/plane.table"
if [ -s "$work/texture.list" ]; then
    EXAMPLES=$work/texture "$here/samples.sh" -n "$runs" -b "$renderboy" -l "$work/texture.list" +W640 +H480 -A +WT1
fi
