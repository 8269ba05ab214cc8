#!/usr/bin/env bash
# Fuzzes lexer, parser and reader, each for some minutes, at low priority; seeds are all scenes and language tests.
# A find is left in build/fuzz/finds: mend it, then keep it in tests/robustness/finds.txt.
# usage: scripts/fuzz.sh [seconds for each target] [targets]
set -euo pipefail
cd "$(dirname "$0")/.."
seconds=${1:-600}
shift || true
targets=${*:-lexer parser reader}
build=build/fuzz
cmake --preset fuzz > /dev/null
nice cmake --build --preset fuzz --target fuzzers > /dev/null
mkdir -p $build/seeds $build/finds
find scenes tests/language -name '*.pov' | while read -r scene; do
    cp "$scene" "$build/seeds/$(echo "$scene" | tr / _)"
done
python3 scripts/split_language_tests.py $build/seeds
# Their grids take half a minute in this build.
grep -lw parametric $build/seeds/* | xargs -r rm
sed -nE 's/^RB_KEYWORD\([a-z0-9_]+, ("[a-z0-9_]+").*/\1/p' grammar/keywords.def > $build/words.dict
for target in $targets; do
    mkdir -p $build/corpus_$target
    nice -n 19 $build/${target}_fuzz $build/corpus_$target $build/seeds -dict=$build/words.dict -max_total_time="$seconds" -max_len=4096 \
        -rss_limit_mb=2048 -malloc_limit_mb=1024 -timeout=10 -artifact_prefix=$build/finds/$target- -print_final_stats=1
done
