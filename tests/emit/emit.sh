#!/bin/sh
# emit.sh RASTERTRACE PROGRAMS TEST: holds what a program of emit.h writes against the readers.
set -eu
rastertrace=$1 programs=$2
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT

fail() {
    echo "$*"
    exit 1
}

# Valid, and no remark but on what is meant: the kind and the fields of its own, and NaN.
validate() { # validate FILE
    "$rastertrace" validate "$1" >"$folder/out" 2>"$folder/remarks" || {
        cat "$folder/remarks"
        fail "$1 is not valid"
    }
}

case $3 in
every-step)
    for program in every-step-c99 every-step-c11 every-step-cpp; do
        "$programs/$program" "$folder/$program.jsonl"
        validate "$folder/$program.jsonl"
        if grep 'remark: fields' "$folder/remarks" | grep -v ': [a-z]*\.code ([0-9]*)\(, [a-z]*\.code ([0-9]*)\)*$'; then
            fail "fields that readers do not know"
        fi
        cmp "$folder/every-step-c99.jsonl" "$folder/$program.jsonl"
    done
    # What JSON has to have escaped, and what is no UTF-8.
    head -n 1 "$folder/every-step-c99.jsonl" | grep -qF \
        '"title":"Every \"step\" \\ of\u000a\u0001 the förmat, \ufffd\ufffd, \ufffd\ufffd\ufffd"' || fail "another title"
    # Each kind that readers know is among them.
    for kind in $("$rastertrace" validate --schema trace | sed -n 's,.*"#/definitions/step-\([a-z]*\)".*,\1,p' | sort -u); do
        grep -q "{\"step\":\"$kind\"" "$folder/every-step-c99.jsonl" || fail "no step $kind"
    done
    ;;
full-disk)
    # Told by the call that has to write: the end of a short trace, a step of a long one. The exit status is that of rt_end.
    for steps in 10 1000000; do
        status=0
        "$programs/limits" /dev/full $steps >"$folder/out" || status=$?
        [ "$status" -eq 1 ] || fail "exit status $status"
        sed 's/limits.c:[0-9]*/PLACE/' "$folder/out"
    done >"$folder/told"
    cmp "$folder/told" - <<'END' || fail "$(cat "$folder/told")"
rt_end in PLACE: the file cannot be written: No space left on device
rt_pixel in PLACE: the file cannot be written: No space left on device
END
    ;;
memory)
    # A million steps are 47 MB.
    # shellcheck disable=SC3045  # dash and bash have ulimit -v
    (ulimit -v 30000 && "$programs/limits" "$folder/long.jsonl" 1000000)
    validate "$folder/long.jsonl"
    grep -q '1000000 steps, complete' "$folder/out" || fail "$(cat "$folder/out")"
    ;;
triangle)
    "$programs/foreign-triangle" "$folder/triangle.jsonl"
    validate "$folder/triangle.jsonl"
    "$rastertrace" diff "$4/t0-fill/first-triangle.json" "$folder/triangle.jsonl" --only scanline,pixel \
        --ignore header,scanline.code,pixel.code
    # Each step has its place: a line of the source with the call of its kind.
    sed -n 's/^{"step":"\([a-z]*\)".*"code":"triangle.c:\([0-9]*\)"}$/\1 \2/p' "$folder/triangle.jsonl" >"$folder/places"
    [ "$(wc -l <"$folder/places")" -eq 59 ] || fail "steps without their place"
    sort -u "$folder/places" | while read -r kind line; do
        sed -n "${line}p" "$4/foreign/triangle.c" | grep -q "rt_$kind(" || fail "no rt_$kind in line $line"
    done
    ;;
esac
