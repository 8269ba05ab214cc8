#!/usr/bin/env bash
# For each shape on its own scene: CPU time and picture error against the exact surface of its mesh at five tolerances
# (pixels), and with hits refined. Writes docs/geometry.md (table) and docs/geometry.svg (plot). Shapes without a mesh have no row.
# usage: bench/geometry.sh [-n RUNS] [-b RENDERBOY]
set -euo pipefail
root=$(cd "$(dirname "$0")/.." && pwd)
runs=3
renderboy=$root/build/release/renderboy
while getopts n:b: option; do
    case $option in
        n) runs=$OPTARG ;;
        b) renderboy=$OPTARG ;;
        *) exit 1 ;;
    esac
done
include=${INCLUDE:-/usr/share/povray-3.7/include}
tolerances=(1 0.3 0.1 0.05 0.02)
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT

# picture NAME SCENE ARGS: renders to $work/NAME.png; the median of user + system seconds into $seconds
picture() {
    local TIMEFORMAT='%U %S'
    seconds=$(for _ in $(seq "$runs"); do
        { time "$renderboy" "+I$2" "+O$work/$1.png" +W640 +H480 -A -D "+L$include" "${@:3}" > /dev/null 2>&1; } 2>&1 | tail -1
    done | awk '{print $1 + $2}' | sort -n | awk '{v[NR] = $1} END {print v[int((NR + 1) / 2)]}')
}

# Of 255, from the exact surface.
rmse() { "$renderboy" diff "$work/exact.png" "$work/mesh.png" | sed -n 's#^rmse \([0-9.]*\)/255.*#\1#p'; }

for scene in "$root"/scenes/shapes/*.pov; do
    shape=$(basename "$scene" .pov)
    picture exact "$scene" --geometry exact
    row="$shape $seconds"
    for tolerance in "${tolerances[@]}"; do
        picture mesh "$scene" --geometry tessellate --tessellation-error "$tolerance"
        row+=" $seconds $(rmse)"
    done
    picture mesh "$scene" --geometry refine --tessellation-error 0.3
    row+=" $seconds $(rmse)"
    echo "$row"
done > "$work/rows"

# A shape whose pictures are all the same has no mesh, or is made of triangles.
awk '{for (i = 4; i <= NF; i += 2) if ($i > 0) {print; next}}' "$work/rows" > "$work/meshed"
{
    echo "# Exact surfaces against meshes"
    echo
    echo "Made by \`bench/geometry.sh -n $runs\`: each scene of \`scenes/shapes/\` at 640x480 without antialiasing, CPU seconds of the whole"
    echo "process, and the root mean square difference (of 255) from the picture of the exact surfaces. A mesh lies within the tolerance, in"
    echo "pixels, of the surface; its normals are those of the true surface. Refined: a mesh within 0.3 pixels, whose hits are moved"
    echo "onto the true surface (\`--geometry refine\`); what is left differs at silhouettes."
    echo "Not listed: shapes that consist of triangles or planes, and those whose meshes would take too many faces"
    echo "(docs/architecture.md, \"Meshes\"): they are always met exactly."
    echo
    echo "![time against error](geometry.svg)"
    echo
    printf '| shape | exact |'; printf ' %s px |' "${tolerances[@]}"; echo ' refined |'
    printf '|---|---|'; printf -- '---|%.0s' "${tolerances[@]}" refined; echo
    awk '{printf "| %s | %.2f s |", $1, $2; for (i = 3; i <= NF; i += 2) printf " %.2f s, %s |", $i, $(i + 1); print ""}' "$work/meshed"
} > "$root/docs/geometry.md"

# Across: time of the mesh over time of the exact surface, 0 to 3; up: error, 1e-4 to 1e1, logarithmic.
awk -v names="${tolerances[*]} refined" '
function x(r) { return 60 + 180 * (r > 3 ? 3 : r) }
function y(e) { e = log(e < 1e-4 ? 1e-4 : e) / log(10); return 330 - 60 * (e + 4) }
BEGIN {
    n = split(names, tolerance, " ")
    split("#b2182b #ef8a62 #999999 #67a9cf #2166ac #1a9850", colour, " ")
    print "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"640\" height=\"380\" font-family=\"sans-serif\" font-size=\"11\">"
    print "<rect width=\"640\" height=\"380\" fill=\"white\"/>"
    for (i = 0; i <= 3; ++i) printf "<path d=\"M%g 30V330\" stroke=\"#ddd\"/><text x=\"%g\" y=\"345\" text-anchor=\"middle\">%d</text>\n", x(i), x(i), i
    for (i = -4; i <= 1; ++i) printf "<path d=\"M60 %gH600\" stroke=\"#ddd\"/><text x=\"55\" y=\"%g\" text-anchor=\"end\">1e%d</text>\n", y(10 ^ i), y(10 ^ i) + 4, i
    print "<text x=\"330\" y=\"365\" text-anchor=\"middle\">time of the mesh / time of the exact surface (3: or more)</text>"
    print "<text x=\"60\" y=\"20\">difference of the pictures, of 255; one point for each shape and tolerance</text>"
    for (k = 1; k <= n; ++k) printf "<circle cx=\"520\" cy=\"%d\" r=\"4\" fill=\"%s\"/><text x=\"530\" y=\"%d\">%s</text>\n", 30 + 15 * k, colour[k], 34 + 15 * k, tolerance[k] (tolerance[k] + 0 ? " pixel" : "")
}
{ for (k = 1; k <= n; ++k) printf "<circle cx=\"%.1f\" cy=\"%.1f\" r=\"3\" fill=\"%s\"><title>%s</title></circle>\n", x($(2 * k + 1) / $2), y($(2 * k + 2)), colour[k], $1 }
END { print "</svg>" }' "$work/meshed" > "$root/docs/geometry.svg"
