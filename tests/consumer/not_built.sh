#!/bin/sh
# not_built.sh SOURCE FOLDER OPTION...: of a build in which the program alone is made, as by demo.sh, nothing is put in
# place, and cmake --install says which command builds the rest.
set -eu
source=$1 folder=$2
shift 2
rm -rf "$folder"
cmake -S "$source" -B "$folder/build" -DRASTERTRACE_BUILD_TESTS=OFF "$@" >/dev/null
: >"$folder/build/viewer-cli/rastertrace"
for component in "" "--component program" "--component development"; do
    # shellcheck disable=SC2086  # an option and its value, or nothing
    if cmake --install "$folder/build" --prefix "$folder/installed" $component >/dev/null 2>"$folder/said"; then
        echo "it installs $component, although that is not built"
        exit 1
    fi
    grep -q "cmake --build $folder/build" "$folder/said" || { cat "$folder/said"; exit 1; }
    [ ! -e "$folder/installed" ] || { echo "something is installed:"; find "$folder/installed"; exit 1; }
done
