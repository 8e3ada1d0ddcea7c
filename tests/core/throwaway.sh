#!/bin/sh
# throwaway.sh COMPILER DRAW INCLUDE...: gives the enumerations of fills and of lines one more, which nothing else
# knows, and fails unless the compiler names every table of algorithms that lacks it. DRAW is core/draw.
set -eu
compiler=$1 draw=$2
shift 2
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT

# The changed header is found before the true one.
header=rastertrace/core/draw/scene/algorithms.h
mkdir -p "$folder/${header%/*}"
sed -e 's/^enum class Fill {$/&\n    throwaway,/' \
    -e 's/^enum class LineMethod { /&throwaway, /' "$draw/include/$header" >"$folder/$header"
[ "$(grep -c throwaway "$folder/$header")" = 2 ] || { echo "the enumerations have another form now"; exit 1; }

for include; do
    set -- "$@" "-I$include"
    shift
done
"$compiler" -std=c++20 -fsyntax-only -Wswitch "-I$folder" "$@" "-I$draw/src" "$draw/src/draw_in_double.cpp" \
    2>"$folder/warnings" || { cat "$folder/warnings"; exit 1; }
warnings=$(grep throwaway "$folder/warnings" | sort -u)
for table in scene/algorithms.h paint/fill.h draw_piece.h; do
    echo "$warnings" | grep -q "$table" || { echo "no warning in $table:"; echo "$warnings"; exit 1; }
done
