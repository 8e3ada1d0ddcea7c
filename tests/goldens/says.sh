#!/bin/sh
# says.sh CMAKE SCRIPT RASTERTRACE EXAMPLES: what the test of a golden says and does, case by case.
set -eu
cmake=$1
script=$2
rastertrace=$3
examples=$4
unset RASTERTRACE_RENEW
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
cd "$folder"
cp "$examples/t0-fill/first-triangle.json" scene.json
sed 's/\[2, 5\]/["2.001", 5]/' scene.json >moved.json

run() { # run MODE ARGUMENT...: what it says is in `said`, on one line
    mode=$1
    shift
    "$cmake" "-DPROGRAM=$rastertrace" -DGOLDEN=golden.jsonl -DTRACE=printed.jsonl "-DRENEWED_BY=renew it" \
        "-DMODE=$mode" "$@" >said 2>&1 && status=0 || status=1
    tr -s '\n ' ' ' <said >line
}
expect() { # expect STATUS TEXT
    [ "$status" = "$1" ] && grep -qF -e "$2" line || {
        echo "expected status $1 and: $2"
        echo "found $status and:"
        cat said
        exit 1
    }
}

run compare -DSCENE=scene.json -P "$script" --
expect 1 "expected the golden golden.jsonl, found no such file; this makes it: renew it"

# A scene, and what may differ.
run renew -DSCENE=scene.json -DKINDS=scanline,pixel -P "$script" --
expect 0 "renewed golden.jsonl"
"$rastertrace" trace scene.json --only scanline,pixel -o drawn.jsonl
cmp golden.jsonl drawn.jsonl
run compare -DSCENE=scene.json -DKINDS=scanline,pixel -P "$script" --
expect 0 "the same"
run compare -DSCENE=moved.json -DKINDS=scanline,pixel -P "$script" --
expect 1 "moved.json differs from its golden. If it should, renew the golden: renew it"
run compare -DSCENE=moved.json -DKINDS=scanline,pixel -DTOLERANCES=scanline.left=1/1000,scanline.right=1/1000 -P "$script" --
expect 0 "the same"
run compare -DSCENE=moved.json -DKINDS=scanline,pixel -DTOLERANCES=scanline.left=1/1000 -P "$script" --
expect 1 "differs"
run compare -DSCENE=moved.json -DKINDS=scanline,pixel -DIGNORED=scanline.left,scanline.right -P "$script" --
expect 0 "the same"
run compare -DSCENE=scene.json -DKINDS=scanline,pixel "-DOPTIONS=--rounding truncate" -P "$script" --
expect 1 "-> truncate -> 0"
run compare -DSCENE=missing.json -DKINDS=pixel -P "$script" --
expect 1 "missing.json could not be compared with golden.jsonl"

# The environment renews, too.
RASTERTRACE_RENEW=0 run compare -DSCENE=moved.json -DKINDS=scanline,pixel -P "$script" --
expect 1 "differs"
export RASTERTRACE_RENEW=1
run compare -DSCENE=moved.json -DKINDS=scanline,pixel -P "$script" --
expect 0 "renewed golden.jsonl"
unset RASTERTRACE_RENEW
run compare -DSCENE=moved.json -DKINDS=scanline,pixel -P "$script" --
expect 0 "the same"

# A program that prints a trace.
"$rastertrace" trace scene.json -o whole.jsonl
run renew -DKINDS=pixel -P "$script" -- cat whole.jsonl
expect 0 "renewed golden.jsonl"
"$rastertrace" trace scene.json --only pixel -o drawn.jsonl
cmp golden.jsonl drawn.jsonl
run compare -DKINDS=pixel -P "$script" -- cat whole.jsonl
expect 0 "the same"
run compare -DKINDS=pixel -P "$script" -- sh -c "exit 3"
expect 1 "sh -c exit 3: ended with 3; it should print a trace"
run renew -DKINDS=pixel -P "$script" -- head -n 20 whole.jsonl
expect 1 "golden.jsonl stays as it was"
cmp golden.jsonl drawn.jsonl

# A typing error in the name of a golden.
run renew -DSCENE=scene.json -DGOLDEN=moved.json -P "$script" --
expect 1 "moved.json: expected a golden to renew, found a file that is no trace"
grep -q '"2.001"' moved.json
