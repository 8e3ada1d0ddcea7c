#!/bin/sh
# Prints what leaving stages out saves (docs/performance.md has results): time, memory and trace of
# planned and full drawing, and what each stage adds where it is kept. Needs jq, and the benchmarks:
#
#     cmake --preset bench && cmake --build build/bench && scripts/stage-table.sh
set -eu
cd "$(dirname "$0")/.."
bench=build/bench/tests/bench/rastertrace-bench
[ -x "$bench" ] || { echo "build the benchmarks first: cmake --preset bench && cmake --build build/bench" >&2; exit 2; }

# The least of many short runs in random order: what disturbs a run only makes it longer.
"$bench" --benchmark_filter='^stages/' --benchmark_min_time=0.02 --benchmark_repetitions=25 \
    --benchmark_enable_random_interleaving=true --benchmark_format=json 2>/dev/null |
    jq -r '
    def round2: . * 100 | round / 100;
    def kib: . / 1024 | round;
    [.benchmarks | map(select(.run_type == "iteration")) | group_by(.run_name)[]
        | {parts: (.[0].run_name | split("/")), time: (map(.cpu_time) | min),
           memory: .[0].memory, trace: .[0].trace}
        | {scene: .parts[1], kept: .parts[2], time, memory, trace}]
    | group_by(.scene) | map({key: .[0].scene, value: (map({key: .kept, value: .}) | from_entries)})
    | (
        "| scene | time: full | plan | full / plan | memory: full | plan | trace: full | plan |",
        "|---|---|---|---|---|---|---|---|",
        (.[] | .key as $scene | .value
            | "| \($scene) | \(.full.time | round2) us | \(.plan.time | round2) us | \(.full.time / .plan.time | round2) | \(.full.memory | kib) KiB | \(.plan.memory | kib) KiB | \(.full.trace | kib) KiB | \(.plan.trace | kib) KiB |"),
        "",
        "| scene | model | view | clip | divide | order | canvas | depth | perspective | colors |",
        "|---|---|---|---|---|---|---|---|---|---|",
        (.[] | .key as $scene | .value as $row
            | "| \($scene) | " + ([("model", "view", "clip", "divide", "order", "canvas", "depth", "perspective", "colors")
                | ($row[.].time / $row.plan.time - 1) * 100 | round | if . >= 0 then "+\(.) %" else "\(.) %" end] | join(" | ")) + " |")
      )'
