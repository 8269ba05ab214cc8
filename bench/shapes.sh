#!/usr/bin/env bash
# CPU time of renderboy against povray for each shape on its own scene (scenes/shapes/<keyword>.pov): bench/samples.sh
# over those scenes. Needs povray. What povray cannot read (polynomial is a word of later versions) has no row.
# usage: bench/shapes.sh [-n RUNS] [-b RENDERBOY] [SWITCHES ...]
set -euo pipefail
here=$(cd "$(dirname "$0")" && pwd)
list=$(mktemp)
trap 'rm -f "$list"' EXIT
(cd "$here/../scenes" && ls shapes/*.pov) | sed 's/\.pov$//' > "$list"
EXAMPLES=$here/../scenes "$here/samples.sh" -l "$list" "$@"
