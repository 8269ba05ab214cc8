#!/usr/bin/env bash
# What reading a scene costs: CPU time and peak memory of both programs in turn on pictures of 4x3 pixels, medians, less
# what an empty scene costs. RenderBoy's own figure for reading alone (`--stats`) stands beside its whole process, which
# includes building the trees.
# usage: bench/parse.sh [-n RUNS] [-b RENDERBOY] [-k FOLDER] [SCENE...]      scenes: spheres mesh macro csg
#   -k  keeps the scenes and times in FOLDER
set -euo pipefail
here=$(cd "$(dirname "$0")" && pwd)
runs=3
renderboy=$here/../build/release/renderboy
work=
while getopts n:b:k: option; do
    case $option in
        n) runs=$OPTARG ;;
        b) renderboy=$OPTARG ;;
        k) work=$OPTARG && mkdir -p "$work" ;;
        *) exit 1 ;;
    esac
done
shift $((OPTIND - 1))
scenes=("$@")
[ ${#scenes[@]} -gt 0 ] || scenes=(spheres mesh macro csg)
if [ -z "$work" ]; then
    work=$(mktemp -d)
    trap 'rm -rf "$work"' EXIT
fi
rm -f "$work"/*.times

head='#version 3.7; global_settings { assumed_gamma 1.0 } camera { location <0, 0, -30> look_at 0 } light_source { <3, 5, -40>, rgb 1 }'
echo "$head sphere { 0, 1 }" > "$work/empty.pov"

# 200,000 statements, every second one with a colour.
awk -v head="$head" 'BEGIN {
    srand(7); print head
    for (i = 0; i < 200000; i++) {
        printf "sphere { <%.4f, %.4f, %.4f>, %.4f", 20 * rand() - 10, 20 * rand() - 10, 20 * rand() - 10, 0.01 + 0.05 * rand()
        if (i % 2) printf " pigment { rgb <%.3f, %.3f, %.3f> }", rand(), rand(), rand()
        print " }"
    }
}' > "$work/spheres.pov"

# A mesh2 of 500,000 triangles.
awk -v head="$head" -v n=500 'BEGIN {
    print head; print "mesh2 { vertex_vectors { " (n + 1) * (n + 1) ","
    for (i = 0; i <= n; i++) for (j = 0; j <= n; j++)
        printf "<%.6f,%.6f,%.6f>,\n", 2 * i / n - 1, 0.12 * sin(18 * i / n - 9) * cos(22 * j / n - 11), 2 * j / n - 1
    print "} face_indices { " 2 * n * n ","
    for (i = 0; i < n; i++) for (j = 0; j < n; j++) {
        a = i * (n + 1) + j; c = a + n + 1
        printf "<%d,%d,%d>,<%d,%d,%d>,\n", a, a + 1, c + 1, a, c + 1, c
    }
    print "} pigment { rgb <0.8, 0.6, 0.4> } }"
}' > "$work/mesh.pov"

# 300,000 turns that call a macro; every tenth makes an object.
cat > "$work/macro.pov" <<SCENE
$head
#macro Step(Position, Speed, Turn)
    #local Size = sqrt(Position.x * Position.x + Position.y * Position.y) / 40 + 0.01;
    #local Bend = mod(Turn * 0.37, 1) - 0.5;
    #declare Walker = Position * 0.999 + Speed * <cos(Turn), sin(Turn), Bend>;
    #if (mod(Turn, 10) = 0)
        sphere { Walker, Size * 0.2 }
    #end
#end
#declare Walker = <1, 0, 0>;
#declare Count = 0;
#while (Count < 300000)
    Step(Walker, 0.1, Count)
    #declare Count = Count + 1;
#end
SCENE

# 100,000 differences in four nested loops.
cat > "$work/csg.pov" <<SCENE
$head
#for (A, 1, 10)
    #for (B, 1, 10)
        #for (C, 1, 10)
            #for (D, 1, 100)
                difference {
                    box { <-0.1, -0.1, -0.1>, <0.1, 0.1, 0.1> rotate y * D }
                    sphere { <0.05, 0.05, -0.1>, 0.08 scale <1, 1 + D / 200, 1> }
                    translate <A * 2 - 11 + 0.01 * D, B * 2 - 11, C * 2 - 11>
                }
            #end
        #end
    #end
#end
SCENE

measure() {  # NAME SCENE PROGRAM OPTION...
    local name=$1 scene=$2
    shift 2
    /usr/bin/time -f '%U %S %M' -o "$work/time" "$@" "+I$work/$scene.pov" "+O$work/$name.png" +W4 +H3 -A -D +WT1 \
        > /dev/null 2> "$work/$name.log" || { cat "$work/$name.log"; exit 1; }
    awk '{print $1 + $2, $3 / 1024}' "$work/time" >> "$work/$name-$scene.times"
}
median() { cut -d' ' -f"$2" "$work/$1.times" | sort -n | awk '{v[NR] = $1} END {print v[int((NR + 1) / 2)]}'; }

for _ in $(seq "$runs"); do
    for scene in empty "${scenes[@]}"; do
        measure povray "$scene" povray
        measure renderboy "$scene" "$renderboy" --stats "$work/stats.json"
        awk -F '[:,]' '/"parse_cpu"/ {cpu = $2} /"parse_peak_memory_kib"/ {print cpu + 0, $2 / 1024}' "$work/stats.json" \
            >> "$work/reading-$scene.times"
    done
done
printf '%-8s %6s %8s %10s %8s %6s %10s %13s %11s\n' scene MB povray renderboy reading ratio povray_MB renderboy_MB reading_MB
for scene in "${scenes[@]}"; do
    echo "$scene $(wc -c < "$work/$scene.pov") $(median "povray-$scene" 1) $(median povray-empty 1)" \
        "$(median "renderboy-$scene" 1) $(median renderboy-empty 1) $(median "reading-$scene" 1) $(median reading-empty 1)" \
        "$(median "povray-$scene" 2) $(median "renderboy-$scene" 2) $(median "reading-$scene" 2)"
done | awk '{
    reading = $7 - $8
    printf "%-8s %6.1f %8.3f %10.3f %8.3f %6.2f %10.0f %13.0f %11.0f\n", \
        $1, $2 / 1e6, $3 - $4, $5 - $6, reading, ($3 - $4) / reading, $9, $10, $11
}'
