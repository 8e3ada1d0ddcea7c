#!/bin/sh
# Makes the plots and tables in docs/numerics/ anew. Times are those of this machine; all other numbers are the
# same everywhere, and docs/numerics.md draws its conclusions from these. Takes a few minutes.
set -eu
cd "$(dirname "$0")/.."
build=${1:-build/release}

[ -f "$build/CMakeCache.txt" ] || cmake --preset release -B "$build"
cmake --build "$build" --target rastertrace_program
rastertrace=$build/viewer-cli/rastertrace

mkdir -p docs/numerics
for scene in friendly stiff extreme; do
    echo "measuring $scene ..." >&2
    "$rastertrace" report "examples/numerics/$scene.json" -o "docs/numerics/$scene.svg" \
        -o "docs/numerics/$scene.txt"
done
