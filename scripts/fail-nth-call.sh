#!/bin/sh
# Lets the program's calls into the system fail: of each kind the first, the second, ... until there
# is none left to fail, each alone and with all that follow, for every command. Whatever fails: the
# exit status is 3, or 0 if the result is whole all the same; a message names the file; an older file
# and the inputs are as they were, and no other file is left.
#
#   scripts/fail-nth-call.sh [--short] [PROGRAM [SHIM]]
#
# --short: trace and show, the first 15 calls of each kind and then every 197th. SHIM is tests/faults/failing_calls.cpp.
# What fails before the program's first line, in the dynamic loader, is not its own to answer for:
# calls count from where the libraries have been loaded.
set -eu
cd "$(dirname "$0")/.."
stride=1
first=1
[ "${1-}" != --short ] || { stride=197; first=15; shift; }
program=$(realpath "${1-build/test/viewer-cli/rastertrace}")
shim=$(realpath "${2-build/test/tests/libfailing_calls.so}")
examples=$(realpath examples)
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
mkdir "$folder/work" "$folder/whole"
cd "$folder/work"

# The inputs: small ones that reach every part of reading and drawing.
mkdir inputs
cp "$examples/t0-fill/first-triangle.json" inputs/scene.json
"$program" trace inputs/scene.json >inputs/trace.json
printf 'v 0 0 1\nv 7 0 0.3\nv 0 7 1\nf 1 2 3\n' >inputs/mesh.obj
cat >inputs/mesh.json <<'JSON'
{"canvas": {"width": 9, "height": 9}, "meshes": [{"obj": "mesh.obj"}],
 "vertices": {"A": ["1e-30", "1/123456789012345678901"], "B": [3, "1e-40"], "C": [1, 4]},
 "triangles": ["ABC"], "method": {"scalar": "exact", "fill": "top-left"}}
JSON
printf 'y=2: -1/4, 25/8 -> -1..3\nA screen: 2, 5\n(3,2): on\n' >inputs/claims.txt
cp -r inputs ../inputs

runs=0
faults=0

complain() {
    echo "fail-nth-call: $1: $2"
    echo "  rastertrace $arguments"
    echo "  status $status; standard error:"
    sed 's/^/  | /' ../err
    faults=$((faults + 1))
}

# check OUTPUT KIND MODE: what has to hold after a run in which a call failed.
check() {
    about="$2, call $n ($3)"
    case $status in
    0)
        [ -z "$1" ] || [ "$is_repeatable" = no ] || cmp -s "$1" ../whole/output ||
            complain "$about" "exit status 0, and another output than without a fault"
        [ "$is_repeatable" = no ] || cmp -s ../out ../whole/out ||
            complain "$about" "exit status 0, and another standard output than without a fault"
        ;;
    3)
        # Where nothing can be written any more, there is no message.
        [ "$2 $3" = "write lasting" ] ||
            grep -Eq '^rastertrace: (out of memory|[^:]+: .+)$' ../err ||
            complain "$about" "no message that names the file"
        if [ "$older" = yes ]; then
            [ "$(cat output.csv)" = old ] || complain "$about" "the older file was lost"
        elif [ -e output.csv ]; then
            complain "$about" "a file was left under the final name"
        fi
        ;;
    *) complain "$about" "exit status $status" ;;
    esac
    diff -r inputs ../inputs >/dev/null || complain "$about" "an input has changed"
    for file in *; do
        case $file in
        inputs | output.csv) ;;
        *)
            complain "$about" "$file was left"
            rm -rf "$file"
            ;;
        esac
    done
}

# try OLDER TMPFILE REPEATABLE ARGUMENTS...: lets the calls of one command fail. OLDER: yes if there
# is a file that the command replaces. TMPFILE: no if the system has no files without a name.
# REPEATABLE: no if two runs write different bytes.
try() {
    older=$1
    tmpfile=$2
    is_repeatable=$3
    shift 3
    arguments=$*
    case $arguments in
    *output.csv*) output=output.csv ;;
    *) output= ;;
    esac
    [ "$tmpfile" = yes ] || export FAIL_TMPFILE=1
    rm -f output.csv
    "$program" "$@" >../whole/out 2>../err
    [ -z "$output" ] || mv output.csv ../whole/output
    for kind in write open close rename fsync read stat malloc; do
        for mode in once lasting; do
            n=0
            while true; do
                n=$((n < first ? n + 1 : n + stride))
                rm -f ../mark output.csv
                [ "$older" = no ] || echo old >output.csv
                always=0
                [ $mode = once ] || always=1
                status=0
                FAIL_CALL=$kind FAIL_AT=$n FAIL_ALWAYS=$always FAIL_MARK=../mark \
                    LD_PRELOAD=$shim "$program" "$@" >../out 2>../err || status=$?
                runs=$((runs + 1))
                [ -e ../mark ] || break
                check "$output" $kind $mode
            done
        done
    done
    unset FAIL_TMPFILE
    rm -f output.csv
}

try yes yes yes trace inputs/mesh.json --format json -o output.csv
try yes no yes trace inputs/scene.json --format json -o output.csv
try no no yes show inputs/mesh.json
try no yes yes figure inputs/scene.json --format gif -o output.csv
if [ $stride = 1 ]; then
    try yes no yes figure inputs/scene.json --format svg -o output.csv
    try no yes yes figure inputs/mesh.json --format png -o output.csv
    try no yes yes figure inputs/trace.json --format tex -o output.csv
    try no yes yes figure inputs/scene.json --format html -o output.csv
    try no yes yes trace inputs/scene.json --format json -o output.csv
    try no no yes trace inputs/scene.json --format json -o output.csv
    try no yes yes trace inputs/scene.json
    try no yes yes show inputs/trace.json --every scanline
    try no yes yes stats inputs/mesh.json
    try no yes yes stats inputs/trace.json --json
    try no yes yes trace inputs/trace.json --flat -o output.csv
    try no yes yes check inputs/scene.json inputs/claims.txt
    try no yes yes diff inputs inputs
    try no yes yes sheet inputs/scene.json
    try no yes yes plan inputs/mesh.json
    try no yes yes stress --case S1
    try no yes yes stress inputs/scene.json
    try no yes yes help
    try no yes yes trace --help
    try yes yes no report --quick --jobs edge inputs/scene.json -o output.csv
    try yes no no report --quick --jobs edge inputs/scene.json -o output.csv
fi

echo "$runs runs, $faults faults"
[ $faults = 0 ]
