#!/bin/sh
# Exercises of the page's module are those of the program.
# usage: same_exercises.sh PROGRAM CMAKE MODULE_FOLDER NODE
set -eu
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
"$2" --build "$3" --target exercises >"$folder/log" 2>&1 || {
    cat "$folder/log"
    exit 1
}
"$1" >"$folder/program"
"$4" "$3/exercises.js" >"$folder/module"
test -s "$folder/program"
cmp "$folder/program" "$folder/module"
