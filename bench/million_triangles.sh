#!/usr/bin/env bash
# A mesh2 of 1,002,528 triangles at 640x480: wall time (parsing included) and peak memory of both programs in turn, medians.
# usage: bench/million_triangles.sh [-n RUNS] [-b RENDERBOY]
set -euo pipefail
here=$(cd "$(dirname "$0")" && pwd)
runs=3
renderboy=$here/../build/release/renderboy
while getopts n:b: option; do
    case $option in
        n) runs=$OPTARG ;;
        b) renderboy=$OPTARG ;;
        *) exit 1 ;;
    esac
done
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT

awk -v n=708 'BEGIN {
    print "#version 3.7; global_settings { assumed_gamma 1.0 }"
    print "camera { location <0, 1.2, -1.6> right x*4/3 look_at <0, 0, 0.1> angle 50 }"
    print "light_source { <3, 5, -4>, rgb 1 }"
    print "mesh2 { vertex_vectors { " (n + 1) * (n + 1) ","
    for (i = 0; i <= n; i++) for (j = 0; j <= n; j++) {
        x = 2 * i / n - 1; z = 2 * j / n - 1
        printf "<%.6f,%.6f,%.6f>,\n", x, 0.12 * sin(9 * x) * cos(11 * z) + 0.01 * sin(140 * x) * sin(150 * z), z
    }
    print "} face_indices { " 2 * n * n ","
    for (i = 0; i < n; i++) for (j = 0; j < n; j++) {
        a = i * (n + 1) + j; b = a + 1; c = a + n + 1; d = c + 1
        printf "<%d,%d,%d>,<%d,%d,%d>,\n", a, b, d, a, d, c
    }
    print "} pigment { rgb <0.8, 0.6, 0.4> } finish { specular 0.3 } }"
}' > "$work/mesh.pov"
ls -l "$work/mesh.pov" | awk '{print "scene: " $5 / 1e6 " MB"}'

measure() {  # NAME PROGRAM
    /usr/bin/time -f '%e %U %S %M' -o "$work/time" "$2" "+I$work/mesh.pov" "+O$work/$1.png" +W640 +H480 -A -D +WT2 \
        > /dev/null 2> "$work/$1.log" || { cat "$work/$1.log"; exit 1; }
    cat "$work/time" >> "$work/$1.times"
}
for _ in $(seq "$runs"); do
    measure povray povray
    measure renderboy "$renderboy"
done
for name in povray renderboy; do
    sort -n "$work/$name.times" | awk -v n="$name" '{w[NR] = $1; c[NR] = $2 + $3; m[NR] = $4}
        END {k = int((NR + 1) / 2); printf "%-10s wall %.2f s  cpu %.2f s  peak memory %.0f MB\n", n, w[k], c[k], m[k] / 1024}'
done
"$renderboy" diff "$work/povray.png" "$work/renderboy.png"
