#!/bin/sh
# Builds the fuzz targets and runs each for some time:
#
#     tests/fuzz/run.sh SECONDS
#
# Needs clang++ with libFuzzer, and Ninja. What the fuzzer learns stays in build/fuzz/corpus and is
# used again by the next run. An input that breaks something is left as build/fuzz/TARGET-crash-...
# (or -timeout-, -oom-, -leak-); to see it fail again, give its name to
# build/fuzz/tests/fuzz/TARGET. Exit status: 0 nothing found, 1 something found, 2 bad usage.
set -eu
case ${1:-} in
'' | *[!0-9]*)
    echo "usage: tests/fuzz/run.sh SECONDS" >&2
    exit 2
    ;;
esac
seconds=$1
cd "$(dirname "$0")/../.."

cmake --preset fuzz -G Ninja
cmake --build --preset fuzz --parallel "${CMAKE_BUILD_PARALLEL_LEVEL:-1}" \
    --target rastertrace_program fuzz_number fuzz_obj fuzz_scene fuzz_trace

# To start from: a few numbers, every model, every example, and its trace in both layouts, whole and
# cut short.
corpus=build/fuzz/corpus
mkdir -p "$corpus/fuzz_number" "$corpus/fuzz_obj" "$corpus/fuzz_scene" "$corpus/fuzz_trace"
for number in -4 0.25 1e-3 25/8 -1/4 1e-320 123456789012345678901/7; do
    printf %s "$number" >"$corpus/fuzz_number/seed-$(printf %s "$number" | tr / _)"
done
for model in examples/models/*.obj; do
    cp "$model" "$corpus/fuzz_obj/seed-$(basename "$model")"
done
for scene in examples/*/*.json; do
    name=$(basename "$scene" .json)
    cp "$scene" "$corpus/fuzz_scene/seed-$name.json"
    for layout in json jsonl; do
        trace=$corpus/fuzz_trace/seed-$name.$layout
        build/fuzz/viewer-cli/rastertrace trace "$scene" --format "$layout" -o "$trace"
        head -n 12 "$trace" >"$corpus/fuzz_trace/seed-$name-cut.$layout"
    done
done

found=0
for target in fuzz_number fuzz_obj fuzz_scene fuzz_trace; do
    echo "$target: $seconds seconds"
    "build/fuzz/tests/fuzz/$target" "$corpus/$target" \
        -dict="tests/fuzz/${target#fuzz_}.dict" -artifact_prefix="build/fuzz/$target-" \
        -max_total_time="$seconds" -timeout=20 -print_final_stats=1 || found=1
done
exit "$found"
