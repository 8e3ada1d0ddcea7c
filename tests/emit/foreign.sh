#!/bin/sh
# foreign.sh RASTERTRACE TRIANGLE EVERY_STEP SOURCE_FOLDER: Python, JavaScript and Rust tell what the triangle of C tells; each
# reports what is called in a wrong order, what is missing, and a full disk. The schema accepts each line.
set -eu
rastertrace=$1 triangle=$2 every_step=$3 source=$4
foreign=$source/examples/foreign
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
export PYTHONDONTWRITEBYTECODE=1 PYTHONPATH="$foreign"

fail() {
    echo "$*"
    exit 1
}

"$triangle" "$folder/c.jsonl"
rustc --edition 2021 -D warnings -o "$folder/rust-triangle" "$foreign/triangle.rs"
python3 "$foreign/triangle.py" "$folder/python.jsonl"
node "$foreign/triangle.mjs" "$folder/node.jsonl"
"$folder/rust-triangle" "$folder/rust.jsonl"
for language in python node rust; do
    "$rastertrace" validate "$folder/$language.jsonl" >/dev/null 2>&1 || fail "$language: not valid"
    "$rastertrace" diff "$folder/c.jsonl" "$folder/$language.jsonl" \
        --ignore primitive.code,scanline.code,pixel.code >"$folder/diff" || fail "$(cat "$folder/diff")"
    # Each place in the code is a line of the triangle's source with a call of `step`.
    sed -n 's/.*"code":"\([^"]*\)".*/\1/p' "$folder/$language.jsonl" | sort -u | while read -r place; do
        sed -n "${place#*:}p" "$foreign/${place%:*}" | grep -q 'step' || fail "$language: no step at $place"
    done
    [ "$(grep -c '"code":"triangle\.' "$folder/$language.jsonl")" -eq 59 ] || fail "$language: steps without their place"
done
for file in rastertrace_emit.py rastertrace_emit.mjs rastertrace_emit.rs; do
    [ "$(wc -l <"$foreign/$file")" -lt 40 ] || fail "$file has 40 lines or more"
done

# What is wrong is told, by its place.
cat >"$folder/wrong.py" <<'END'
import math, sys
from rastertrace_emit import Trace
trace = Trace(sys.argv[1], 9, 9, "center", {})
trace.step("depth", {"x": 1, "y": 2, "depth": -math.inf, "stored": math.nan, "also": [-0.0, math.inf]})
for call in [lambda: trace.step("pixel", {"x": 1}), trace.end, lambda: trace.step("pixel", {"x": 1, "y": 2}), trace.end]:
    try:
        call()
    except ValueError as error:
        print(error)
END
cat >"$folder/wrong.mjs" <<END
import {Trace} from "$foreign/rastertrace_emit.mjs";
const trace = new Trace(process.argv[2], 9, 9, "center", {});
trace.step("depth", {x: 1, y: 2, depth: -Infinity, stored: NaN, also: [-0, Infinity]});
for (const call of [() => trace.step("pixel", {x: 1}), () => trace.end(), () => trace.step("pixel", {x: 1, y: 2})])
    try { call(); } catch (error) { console.log(error.message); }
END
cat >"$folder/wrong.rs" <<END
#[macro_use]
#[path = "$foreign/rastertrace_emit.rs"]
mod rastertrace_emit;
fn main() {
    let path = std::env::args().nth(1).unwrap();
    let mut trace = rastertrace_emit::Trace::new(&path, 9, 9, "center", "").unwrap();
    step!(trace, "depth", x = 1, y = 2, depth = f64::NEG_INFINITY, stored = f64::NAN, also = [-0.0, f64::INFINITY]).unwrap();
    println!("{}", step!(trace, "pixel", x = 1).unwrap_err());
    trace.end().unwrap();
    println!("{}", step!(trace, "pixel", x = 1, y = 2).unwrap_err());
    trace.end().unwrap_err();
}
END
rustc --edition 2021 -D warnings -o "$folder/wrong" "$folder/wrong.rs"
python3 "$folder/wrong.py" "$folder/python.jsonl" >"$folder/python.txt"
node "$folder/wrong.mjs" "$folder/node.jsonl" >"$folder/node.txt"
"$folder/wrong" "$folder/rust.jsonl" >"$folder/rust.txt"
for language in python node rust; do
    sed -n 's/ in wrong\.[a-z]*:[0-9]*:/:/p' "$folder/$language.txt" >"$folder/told.txt"
    printf 'pixel: expected y\npixel: expected it before the end\n' | cmp - "$folder/told.txt" || fail "$(cat "$folder/$language.txt")"
    "$rastertrace" validate "$folder/$language.jsonl" >/dev/null 2>&1 || fail "$language: NaN is not valid"
    grep -q '"depth":"-inf","stored":"NaN","also":\[\(0\|0\.0\),"inf"\]' "$folder/$language.jsonl" ||
        fail "$(cat "$folder/$language.jsonl")"
done

for program in "python3 $foreign/triangle.py" "node $foreign/triangle.mjs" "$folder/rust-triangle"; do
    # shellcheck disable=SC2086  # a command with its argument
    ! $program /dev/full 2>"$folder/told.txt" || fail "$program: a full disk is no fault"
    grep -qi 'no space left on device' "$folder/told.txt" || fail "$(cat "$folder/told.txt")"
done

# Each line that emit.h can write is one that the schema accepts. Debian's Python has the package.
"$every_step" "$folder/every.jsonl"
/usr/bin/python3 - "$folder/every.jsonl" "$source/docs/trace.schema.json" <<'END'
import json, sys, jsonschema
validator = jsonschema.Draft7Validator(json.load(open(sys.argv[2])))
for line in open(sys.argv[1]):
    validator.validate(json.loads(line))
END
