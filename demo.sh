#!/bin/sh
# Shows the worked example as soon as what draws it is built, and builds the rest of rastertrace behind it. Installs what is
# missing first, and says so.
set -eu
cd "$(dirname "$0")"

# shellcheck disable=SC2046  # a list of words
scripts/install-packages.sh $(cat scripts/program-packages.txt)
[ -f build/release/build.ninja ] || cmake --preset release -G Ninja >/dev/null

program=build/release/viewer-cli/rastertrace
scene=examples/t0-fill/first-triangle.json
cmake --build build/release --target rastertrace_first_picture
${program}_first_picture $scene
echo
echo "Now the rest of the program, which takes as long again:"
cmake --build build/release --target rastertrace_program
echo
echo "The program is $PWD/$program. To go through this step by step, and back:"
echo "    $program play $scene"
echo "The tutorial begins in docs/tutorial/README.md."
