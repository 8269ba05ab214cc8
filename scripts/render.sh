#!/usr/bin/env bash
# Installs what is missing, builds RenderBoy and renders a scene to a PNG. Works on a fresh Debian 12.
# usage: scripts/render.sh [SCENE.pov [more options of renderboy]]
set -euo pipefail
root=$(cd "$(dirname "$0")/.." && pwd)
"$root/scripts/install_packages.sh" build
(cd "$root" && cmake --preset release > build_release.log 2>&1 && cmake --build --preset release >> build_release.log 2>&1) ||
    { cat "$root/build_release.log" >&2; exit 1; }
rm -f "$root/build_release.log"
if [ $# -eq 0 ]; then
    set -- "$root/scenes/gallery/still_life.pov" --size 640x480 +A0.3 -o still_life.png
fi
exec "$root/build/release/renderboy" "$@"
