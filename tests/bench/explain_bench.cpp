// SPDX-License-Identifier: MIT
// A pixel explained from a trace, which is read for that, against counting the lines of its file:
// `explain/lines` and `explain/pixel`, on a head of 38,080 triangles.

#include "trace_file.h"

#include <rastertrace/trace/explain/explain.h>
#include <rastertrace/trace/record/trace.h>

#include <benchmark/benchmark.h>

#include <filesystem>
#include <string>

namespace rastertrace {
namespace {

void explain_lines(benchmark::State& state) {
    const std::string& path = head_trace_path();
    for (auto _ : state)
        benchmark::DoNotOptimize(count_lines(path));
    state.SetBytesProcessed(static_cast<std::int64_t>(state.iterations()) *
                            static_cast<std::int64_t>(std::filesystem::file_size(path)));
}

void explain_pixel(benchmark::State& state) {
    const std::string& path = head_trace_path();
    const Question question{.about = Topic::pixel, .pixel = {10, 20}};
    for (auto _ : state) {
        const Result<Trace> trace = read_trace(read_source(path).value());
        benchmark::DoNotOptimize(explain(trace.value(), question));
    }
    state.SetBytesProcessed(static_cast<std::int64_t>(state.iterations()) *
                            static_cast<std::int64_t>(std::filesystem::file_size(path)));
}

BENCHMARK(explain_lines)->Name("explain/lines")->Unit(benchmark::kMillisecond);
BENCHMARK(explain_pixel)->Name("explain/pixel")->Unit(benchmark::kMillisecond);

} // namespace
} // namespace rastertrace
