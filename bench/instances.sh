#!/usr/bin/env bash
# Copies of a union of 1,000 spheres, 320x240: CPU time and peak memory of both programs. POV-Ray holds every sphere of every copy, several
# GB for 10,000 copies: -p says how many it gets (0: none), -c how many RenderBoy gets.
# usage: bench/instances.sh [-c COPIES] [-p COPIES_FOR_POVRAY] [-b RENDERBOY]
set -euo pipefail
here=$(cd "$(dirname "$0")" && pwd)
copies=10000
povray_copies=1000
renderboy=$here/../build/release/renderboy
while getopts c:p:b: option; do
    case $option in
        c) copies=$OPTARG ;;
        p) povray_copies=$OPTARG ;;
        b) renderboy=$OPTARG ;;
        *) exit 1 ;;
    esac
done
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT

scene() {  # COPIES
    cat << END
#version 3.7; global_settings { assumed_gamma 1.0 }
camera { location <0, 60, -120> right x*4/3 look_at 0 }
light_source { <50, 90, -120>, rgb 1 }
#declare S = seed(1);
#declare Bush = union {
  #for (I, 1, 1000) sphere { <rand(S), rand(S), rand(S)> - 0.5, 0.03 } #end
  pigment { rgb <0.3, 0.8, 0.2> }
}
#for (I, 0, $1 - 1) object { Bush rotate y*I*7 translate <mod(I, 100) - 50, 0, floor(I/100) - 50> } #end
END
}
measure() {  # PROGRAM COPIES [SWITCH ...]
    scene "$2" > "$work/scene.pov"
    /usr/bin/time -f '%U %S %M' -o "$work/time" "$1" "+I$work/scene.pov" "+O$work/out.png" +W320 +H240 -A -D +WT1 "${@:3}" \
        > /dev/null 2> "$work/log" || { cat "$work/log"; exit 1; }
    awk -v n="$(basename "$1") ${*:3}" -v c="$2" '{printf "%-30s %6d copies  cpu %.2f s  peak memory %.0f MB\n", n, c, $1 + $2, $3 / 1024}' "$work/time"
}
measure "$renderboy" "$copies"
[ "$povray_copies" -gt 0 ] || exit 0
measure "$renderboy" "$povray_copies"
measure "$renderboy" "$povray_copies" --instances never
measure povray "$povray_copies"
