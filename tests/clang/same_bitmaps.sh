#!/bin/sh
# same_bitmaps.sh PROGRAM COMPILER... -- ARGUMENT...: fails if the program that a COMPILER (a command with its options)
# makes of the arguments prints other bytes than PROGRAM.
set -eu
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
"$1" >"$folder/expected"
[ -s "$folder/expected" ]
shift
while [ "$1" != -- ]; do
    printf '%s\n' "$1" >>"$folder/compilers"
    shift
done
shift
# The sources among the arguments are compiled as one: what they include is read once.
for argument; do
    shift
    case $argument in
    *.cpp) echo "#include \"$argument\"" >>"$folder/sources.cpp" ;;
    *) set -- "$@" "$argument" ;;
    esac
done
while read -r compiler; do
    # shellcheck disable=SC2086  # a command with options
    $compiler "$folder/sources.cpp" "$@" -o "$folder/program" </dev/null
    "$folder/program" >"$folder/found"
    cmp "$folder/expected" "$folder/found" || { echo "other bytes by $compiler" >&2; exit 1; }
    echo "the same by $compiler"
done <"$folder/compilers"
