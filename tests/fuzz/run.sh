#!/bin/sh
# Builds the fuzz targets and runs each, or those that are named, for some time or with so many inputs:
#
#     tests/fuzz/run.sh SECONDS [TARGET...]
#     tests/fuzz/run.sh INPUTSx [TARGET...]        # 1000000x fuzz_scene
#
# Needs clang++ with libFuzzer, and Ninja. What the fuzzer learns stays in build/fuzz/corpus and is
# used again by the next run. An input that breaks something is left as build/fuzz/TARGET-crash-...
# (or -timeout-, -oom-, -leak-); to see it fail again, give its name to
# build/fuzz/tests/fuzz/TARGET. Exit status: 0 nothing found, 1 something found, 2 bad usage.
set -eu
all="fuzz_claims fuzz_number fuzz_obj fuzz_picture fuzz_scene fuzz_trace fuzz_words"
usage() {
    echo "usage: tests/fuzz/run.sh SECONDS|INPUTSx [$all]..." >&2
    exit 2
}
case ${1:-} in
*x) limit=-runs=${1%x} ;;
*) limit=-max_total_time=${1:-} ;;
esac
case ${limit#*=} in
'' | *[!0-9]*) usage ;;
esac
shift
# shellcheck disable=SC2086  # a list of words
[ $# -gt 0 ] || set -- $all
for target; do
    case " $all " in *" $target "*) ;; *) usage ;; esac
done
cd "$(dirname "$0")/../.."

cmake --preset fuzz -G Ninja
cmake --build --preset fuzz --parallel "${CMAKE_BUILD_PARALLEL_LEVEL:-1}" \
    --target rastertrace_program "$@"

# To start from: claims, a few numbers, the models, small pictures, the examples, and traces of them in
# both layouts, cut short. What is longer than an input may be is cut.
longest=2560
corpus=build/fuzz/corpus
for target in $all; do
    mkdir -p "$corpus/$target"
done
for claims in examples/claims/*; do
    head -c "$longest" "$claims" >"$corpus/fuzz_claims/seed-$(basename "$claims")"
done
for number in -4 0.25 1e-3 25/8 -1/4 1e-320 123456789012345678901/7; do
    printf %s "$number" >"$corpus/fuzz_number/seed-$(printf %s "$number" | tr / _)"
done
for model in examples/models/*.obj; do
    head -c "$longest" "$model" >"$corpus/fuzz_obj/seed-$(basename "$model")"
done
for scene in examples/*/*.json; do
    name=$(basename "$scene" .json)
    cp "$scene" "$corpus/fuzz_scene/seed-$name.json"
    for layout in json jsonl; do
        build/fuzz/viewer-cli/rastertrace trace "$scene" --format "$layout" |
            head -c "$longest" >"$corpus/fuzz_trace/seed-$name.$layout"
    done
done

# Whole traces that are short enough: a small triangle by every fill.
small='{"canvas":{"width":6,"height":5},"vertices":{"A":[2,2],"B":[-2,-1],"C":[2,-2]},"triangles":["ABC"]}'
for fill in scanline two-halves barycentric top-left fan; do
    printf %s "$small" | build/fuzz/viewer-cli/rastertrace trace - --fill "$fill" --scalar exact \
        >"$corpus/fuzz_trace/seed-small-$fill.json"
done

# Its picture as rows of text and as PNG, and others of few pixels.
printf %s "$small" | build/fuzz/viewer-cli/rastertrace show - --bare >"$corpus/fuzz_picture/seed-rows"
printf %s "$small" | build/fuzz/viewer-cli/rastertrace figure - --bare -o "$corpus/fuzz_picture/seed-small.png"
printf 'P1 3 2 010 1#\n10' >"$corpus/fuzz_picture/seed-bits"
printf 'P3 2 1 255 1 2 3 4 5 6' >"$corpus/fuzz_picture/seed-text"
printf 'P5 2 1 65535\n\1\2\3\4' >"$corpus/fuzz_picture/seed-grays"
printf '\0\1\11\0\0\1\0\30\0\0\0\0\3\0\2\0\10\0\1\2\3\204\0\0\0' >"$corpus/fuzz_picture/seed-palette"

# What makes a run slow and finds nothing: weighing inputs by rare features, keeping much freed memory, and
# deep stacks of every allocation.
export ASAN_OPTIONS="${ASAN_OPTIONS:-quarantine_size_mb=8:malloc_context_size=4}"
found=0

# What is typed: a byte that chooses the reader, and a text.
words=0
for text in '0scanline y=2' '0depth x=3 y=2 fail' '0pixel in=ABC' '1/vertices/A/0=0:5:6' '1/canvas/width=6,7' \
    '2fill=top-left,sample=1/4 0' '8{"fill": "top-left", "sample": ["1/4", 0]}' '4```
$ rastertrace show small.json # exit 2
...
```'; do
    words=$((words + 1))
    printf %s "$text" >"$corpus/fuzz_words/seed-$words"
done

for target; do
    echo "$target: $limit"
    "build/fuzz/tests/fuzz/$target" "$corpus/$target" "$limit" -max_len="$longest" -entropic=0 \
        -dict="tests/fuzz/${target#fuzz_}.dict" -artifact_prefix="build/fuzz/$target-" \
        -timeout=20 -print_final_stats=1 || found=1
done
exit "$found"
