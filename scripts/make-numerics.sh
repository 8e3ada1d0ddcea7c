#!/bin/sh
# Makes the plots of docs/numerics/ and the tables between the marks of docs/numerics.md anew. Times are
# those of this machine; all other numbers are the same everywhere. Takes a few minutes.
set -eu
cd "$(dirname "$0")/.."
build=${1:-build/release}

[ -f "$build/CMakeCache.txt" ] || cmake --preset release -B "$build"
cmake --build "$build" --target rastertrace_program
rastertrace=$build/viewer-cli/rastertrace
tables=$(mktemp)
trap 'rm -f "$tables" "$tables.md"' EXIT

mkdir -p docs/numerics
for scene in friendly stiff extreme; do
    echo "measuring $scene ..." >&2
    "$rastertrace" report "examples/numerics/$scene.json" -o "docs/numerics/$scene.svg" \
        -o "$tables.txt"
    printf '\n### %s\n\n' "$scene"
    printf '![Plots of the %s scene](numerics/%s.svg)\n\n' "$scene" "$scene"
    printf '```\n%s\n```\n' "$(cat "$tables.txt")"
    rm "$tables.txt"
done >"$tables"
echo "measuring one edge ..." >&2
"$rastertrace" report examples/numerics/edge.json --jobs edge -o docs/numerics/edge.svg

# What stands between the marks is replaced.
awk -v tables="$tables" '
    /<!-- report: end -->/ { inside = 0 }
    !inside { print }
    /<!-- report: begin/ {
        inside = 1
        while ((getline line < tables) > 0) print line
    }' docs/numerics.md >"$tables.md"
cat "$tables.md" >docs/numerics.md
