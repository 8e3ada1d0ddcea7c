#!/bin/sh
# Builds rastertrace and shows the worked example. Installs what is missing first, and says so.
set -eu
cd "$(dirname "$0")"

# shellcheck disable=SC2046  # a list of words
scripts/install-packages.sh $(cat scripts/program-packages.txt)
[ -f build/release/build.ninja ] || cmake --preset release -G Ninja >/dev/null
cmake --build build/release --target rastertrace_program

rastertrace=build/release/viewer-cli/rastertrace
scene=examples/t0-fill/first-triangle.json
$rastertrace show $scene
echo
echo "The program is $PWD/$rastertrace. To go through this step by step, and back:"
echo "    $rastertrace play $scene"
echo "The tutorial begins in docs/tutorial/README.md."
