#!/usr/bin/env bash
# The longer checks, for before a change is called done: clang-tidy over all sources, image tests under the sanitizers, every
# installed sample scene and include file read (scripts/check_samples.sh) and every scene rendered small (none may crash or
# hang), the numerical stress suite, and the contract with callers run against POV-Ray itself, where it is installed. Most of an hour on two cores.
# usage: scripts/slow_checks.sh
set -euo pipefail
cd "$(dirname "$0")/.."
scripts/install_packages.sh test
failed=0

echo "== image tests under the sanitizers"
cmake --preset asan > /dev/null
cmake --build --preset asan --target image_tests renderboy
ctest --preset asan -L images || failed=1

echo "== every sample scene and include file is read"
scripts/check_samples.sh build/asan/renderboy || failed=1

if command -v povray > /dev/null; then
    echo "== the contract with callers holds for POV-Ray"
    cmake --build --preset asan --target app_tests
    RB_CONTRACT_PROGRAM=$(command -v povray) build/asan/app_tests --gtest_filter='Rows/*' ||
        failed=1
fi

echo "== sample scenes"
examples=${EXAMPLES:-/usr/share/doc/povray/examples}
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
renderboy=$PWD/build/asan/renderboy
while read -r scene; do
    code=0
    (cd "$(dirname "$scene")" && timeout 300 "$renderboy" "+I$(basename "$scene")" "+O$work/out.png" +W80 +H60 -A -V \
        +L/usr/share/povray-3.7/include +L. > "$work/log" 2>&1) || code=$?
    if [ "$code" -gt 1 ]; then
        echo "exit code $code: $scene"
        tail -3 "$work/log"
        failed=1
    fi
done < <(find "$examples" -name '*.pov' | sort)

echo "== numerical stress, a hundredth of it"
RB_STRESS_SHARE=0.01 scripts/stress.sh || failed=1

echo "== clang-tidy"
command -v clang-tidy > /dev/null || { echo "install clang-tidy"; exit 1; }
cmake --preset dev > /dev/null
find src grammar -name '*.cpp' | xargs -P 2 -n 4 clang-tidy --quiet -p build/dev || failed=1
exit $failed
