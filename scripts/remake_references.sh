#!/usr/bin/env bash
# Renders scenes/**/*.pov with POV-Ray 3.7 into reference_images/ (same folders), and records version and command.
# usage: scripts/remake_references.sh [SCENE.pov ...]     all scenes without arguments
set -euo pipefail
cd "$(dirname "$0")/.."
povray=${POVRAY:-povray}
size=(+W160 +H120)
fixed=(-A -D -P -V +FN8 +WT2)

scenes=("$@")
if [ ${#scenes[@]} -eq 0 ]; then
    mapfile -t scenes < <(find scenes -name '*.pov' | sort)
fi
for scene in "${scenes[@]}"; do
    out=reference_images/${scene#scenes/}
    out=${out%.pov}.png
    mkdir -p "$(dirname "$out")"
    # A scene may ask for more switches in a line "// options: ...".
    read -r -a options <<< "$(sed -n 's#^// options: ##p' "$scene")"
    if ! "$povray" "+I$scene" "+O$out" "+L$(dirname "$scene")" "${size[@]}" "${fixed[@]}" "${options[@]}" > /tmp/remake.log 2>&1; then
        echo "failed: $scene" >&2
        grep -A2 Error /tmp/remake.log >&2 || true
        exit 1
    fi
done
{
    echo "# How these pictures were made; written by scripts/remake_references.sh."
    "$povray" --version 2>&1 | grep -m1 '^POV-Ray'
    echo "povray +I<scene> +O<picture> +L<folder of the scene> ${size[*]} ${fixed[*]} <options of the scene>"
} > reference_images/made_with.txt
echo "${#scenes[@]} pictures"
