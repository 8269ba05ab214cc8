#!/usr/bin/env bash
# Installs the Debian packages that are missing. usage: scripts/install_packages.sh build|test
set -euo pipefail
build=(g++ cmake ninja-build libtbb-dev libfmt-dev libglm-dev libopenimageio-dev libpng-dev libjpeg62-turbo-dev libfreetype-dev
       tao-pegtl-dev libcli11-dev nlohmann-json3-dev)
test=(libgtest-dev libboost-dev ccache clang-format povray-includes povray-examples)

packages=("${build[@]}")
[ "${1:-build}" = test ] && packages+=("${test[@]}")

missing=()
for package in "${packages[@]}"; do
    dpkg-query -W -f '${Status}' "$package" 2>/dev/null | grep -q 'ok installed' || missing+=("$package")
done
[ ${#missing[@]} -eq 0 ] && exit 0

echo "installing: ${missing[*]}" >&2
as_root=()
if [ "$(id -u)" -ne 0 ]; then
    as_root=(sudo)
fi
"${as_root[@]}" apt-get update -q >&2
"${as_root[@]}" env DEBIAN_FRONTEND=noninteractive apt-get install -q -y --no-install-recommends "${missing[@]}" >&2
