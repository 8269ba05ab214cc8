#!/usr/bin/env bash
# Every installed sample scene and every scene of ours, rendered by povray and by renderboy with the same switches: a table of
# differences, times and memory, and a page with all pictures (`renderboy compare`). A run that was interrupted goes on where
# it stopped; povray's side is rendered once for each set of switches. Needs povray and povray-examples.
# usage: bench/conformance.sh [-b RENDERBOY] [-o FOLDER] [-s WORD] [SWITCHES ...]
# default: FOLDER build/conformance (page.html, table.tsv, runs/), all scenes (-s: those whose path contains WORD),
# +W160 +H120 -A +WT2
set -euo pipefail
root=$(cd "$(dirname "$0")/.." && pwd)
renderboy=$root/build/release/renderboy
folder=$root/build/conformance
word=
while getopts b:o:s: option; do
    case $option in
        b) renderboy=$OPTARG ;;
        o) folder=$OPTARG ;;
        s) word=$OPTARG ;;
        *) exit 1 ;;
    esac
done
shift $((OPTIND - 1))
[ $# -eq 0 ] && set -- +W160 +H120 -A +WT2
examples=${EXAMPLES:-/usr/share/doc/povray/examples}
include=${INCLUDE:-/usr/share/povray-3.7/include}

renderboy=$(realpath "$renderboy")
mkdir -p "$folder/runs"
folder=$(realpath "$folder")
find "$examples" "$root/scenes" -name '*.pov' | grep -F -- "$word" | sort > "$folder/scenes.txt"
# Some scenes write files: into a folder that goes away.
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
cd "$work"
"$renderboy" compare --list "$folder/scenes.txt" --cache "$folder/runs" --html "$folder/page.html" \
    --table "$folder/table.tsv" --timeout 120 "+L$include" "$@"
