#!/usr/bin/env bash
# `renderboy check` over every installed sample scene, its INI file if it has one, and every standard include file: none may
# hold a word or syntax that is not known. What POV-Ray itself refuses with the same message is fine.
# usage: scripts/check_samples.sh RENDERBOY
set -uo pipefail
renderboy=$(realpath "$1")
examples=${EXAMPLES:-/usr/share/doc/povray/examples}
includes=${INCLUDES:-/usr/share/povray-3.7/include}
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
# Some scenes write files beside themselves.
cp -r "$examples" "$work/examples"
examples=$work/examples
failed=0 read=0 refused=0

# The first error in the reference's words, unwrapped, without our hints.
first_error() {
    awk '/ Parse Error: |^Parse Error: / && !/Possible/ && !found { found = 1; text = $0; next }
         found == 1 && /^ [^ ]/ { text = text $0; next }
         found == 1 { found = 2 }
         /^Fatal error in parser: Cannot open file/ && !found { text = "Cannot open file." }
         END { sub(/.*Parse Error: /, "", text); sub(/Cannot open (image|font) file.*/, "Cannot open file.", text); sub(/ \(did you mean.*/, "", text); print text }' "$1"
}

# check_one NAME ARGUMENTS...: run in the scene's folder
check_one() {
    local name=$1
    shift
    timeout 300 "$renderboy" check "$@" "+L$includes" > "$work/out" 2> "$work/err"
    if [ $? -le 1 ] && ! grep -q 'Parse Error' "$work/err"; then
        read=$((read + 1))
        return
    fi
    if command -v povray > /dev/null; then
        timeout 300 povray "$@" "+L$includes" +W1 +H1 -A -D -P -F > /dev/null 2> "$work/theirs" < /dev/null
        if [ -n "$(first_error "$work/theirs")" ] && [ "$(first_error "$work/theirs")" = "$(first_error "$work/err")" ]; then
            refused=$((refused + 1))
            return
        fi
    fi
    echo "failed: $name: $(first_error "$work/err")"
    failed=1
}

while read -r scene; do
    cd "$(dirname "$scene")" || exit 1
    name=${scene#"$examples"/}
    check_one "$name" "+I$(basename "$scene")"
    ini=$(basename "${scene%.pov}.ini")
    [ -f "$ini" ] && [ "$ini" != __empty.ini ] && check_one "${name%.pov}.ini" "$ini"
done < <(find "$examples" -name '*.pov' | sort)

cd "$work" || exit 1
for include in "$includes"/*.inc; do
    name=$(basename "$include")
    printf '#version 3.7;\nglobal_settings { assumed_gamma 1.0 }\n#include "%s"\nsphere { 0, 1 }\n' "$name" > include.pov
    check_one "$name" +Iinclude.pov
done
echo "$read read, $refused refused as POV-Ray does"
exit $failed
