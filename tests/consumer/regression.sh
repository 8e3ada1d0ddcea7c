#!/bin/sh
# regression.sh EXAMPLES FOLDER PREFIX CMAKE_OPTION...: the project of examples/regression as its reader has it, against the
# rastertrace that is installed in PREFIX. Its tests pass; with a mistake in its rasterizer they fail, and say what to do;
# and so it is done.
set -eu
examples=$1
folder=$2
prefix=$3
shift 3
rm -rf "$folder"
mkdir -p "$folder"
cp -R "$examples" "$folder/examples"
cd "$folder"
export PATH="$prefix/bin:$PATH"
unset CTEST_OUTPUT_ON_FAILURE

quietly() { # quietly COMMAND...: shows what it prints if it fails
    "$@" >log 2>&1 || { cat log; exit 1; }
}
quietly cmake -S examples/regression -B build -DCMAKE_PREFIX_PATH="$prefix" "$@"
quietly cmake --build build
quietly ctest --test-dir build --output-on-failure
cmp build/mine.jsonl examples/regression/mine.jsonl

# What the workflow for a CI server says to rastertrace.
sed -n 's/^ *run: \(rastertrace .*\)/\1/p' examples/ci/workflow.yml >commands
[ "$(wc -l <commands)" -ge 4 ]
while read -r command; do
    quietly sh -c "$command" </dev/null
done <commands

# A mistake.
quietly cmake -DFAST=ON build
quietly cmake --build build
cmp build/mine.jsonl examples/regression/fast.jsonl
! ctest --test-dir build --output-on-failure >failed 2>&1 || { echo "expected tests that fail"; exit 1; }
while read -r line; do
    grep -qF -e "$line" failed || { cat failed; echo "expected: $line"; exit 1; }
done <<'LINES'
25% tests passed, 3 tests failed out of 4
the pictures: 4 pixels only in a
cmake --build
--target renew-mine
Expected: plots pixel (-1, 2)
Expected: shows the picture
LINES

# It was none.
quietly cmake --build build --target renew-mine
quietly ctest --test-dir build --output-on-failure -R '^mine$'
rastertrace trace examples/regression/fast.jsonl --only primitive,scanline,pixel --format jsonl |
    cmp - examples/regression/mine.golden.jsonl
