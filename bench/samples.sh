#!/usr/bin/env bash
# CPU time of renderboy against povray on installed sample scenes: both programs in turn, medians, ratio per scene and
# geometric mean. Needs povray and povray-examples.
# usage: bench/samples.sh [-n RUNS] [-b RENDERBOY] [-l LIST] [SWITCHES ...]
# default: 5 runs, samples.txt beside this script (shape_samples.txt has samples of single shapes), +W640 +H480 +A0.3 +WT2.
# What takes povray more than a minute runs once.
set -euo pipefail
here=$(cd "$(dirname "$0")" && pwd)
runs=5
renderboy=$here/../build/release/renderboy
list=$here/samples.txt
while getopts n:b:l: option; do
    case $option in
        n) runs=$OPTARG ;;
        b) renderboy=$OPTARG ;;
        l) list=$OPTARG ;;
        *) exit 1 ;;
    esac
done
shift $((OPTIND - 1))
[ $# -eq 0 ] && set -- +W640 +H480 +A0.3 +WT2
examples=${EXAMPLES:-/usr/share/doc/povray/examples}
include=${INCLUDE:-/usr/share/povray-3.7/include}
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT

# cpu_time PROGRAM SCENE ARGS: user + system seconds of one run, into $seconds
cpu_time() {
    local TIMEFORMAT='%U %S'
    seconds=$({ time "$1" "+I$2" "+O$work/out.png" -D "+L$include" "+L$(dirname "$2")" "${@:3}" > /dev/null 2> "$work/log"; } 2>&1 |
        tail -1 | awk '{print $1 + $2}')
}
median() { sort -n | awk '{v[NR] = $1} END {print (NR % 2) ? v[(NR + 1) / 2] : (v[NR / 2] + v[NR / 2 + 1]) / 2}'; }

printf '%-42s %9s %10s %7s\n' "CPU seconds, median of $runs: $*" povray renderboy ratio
while read -r name; do
    scene=$examples/$name.pov
    for _ in $(seq "$runs"); do
        cpu_time povray "$scene" "$@"
        echo "$seconds" >> "$work/theirs"
        cpu_time "$renderboy" "$scene" "$@"
        echo "$seconds" >> "$work/ours"
        if awk '$1 > 60 {exit 1}' "$work/theirs"; then continue; else break; fi
    done
    theirs=$(median < "$work/theirs")
    ours=$(median < "$work/ours")
    rm "$work/theirs" "$work/ours"
    awk -v n="$name" -v a="$theirs" -v b="$ours" 'BEGIN {printf "%-42s %9.3f %10.3f %7.2f\n", n, a, b, a / (b > 0.001 ? b : 0.001)}' |
        tee -a "$work/table"
done < "$list"
awk '{s += log($NF); if (min == "" || $NF < min) min = $NF} END {printf "geometric mean %.2f, slowest %.2f\n", exp(s / NR), min}' "$work/table"
