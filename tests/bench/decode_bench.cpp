// SPDX-License-Identifier: MIT
// The steps of a trace in memory, decoded with every field checked, against counting its lines by memchr:
// `decode/lines` and `decode/steps`, on a head of 38,080 triangles.

#include "trace_file.h"

#include <rastertrace/trace/record/step_decoder.h>

#include <benchmark/benchmark.h>

#include <algorithm>
#include <cstddef>
#include <fstream>
#include <iterator>
#include <string>
#include <string_view>

namespace rastertrace {
namespace {

const std::string& head_trace() {
    static const std::string text = [] {
        std::ifstream file(head_trace_path(), std::ios::binary);
        return std::string{std::istreambuf_iterator<char>(file), {}};
    }();
    return text;
}

void decode_lines(benchmark::State& state) {
    const std::string_view text = head_trace();
    for (auto _ : state) {
        std::size_t lines = 0;
        for (std::size_t at = 0; (at = text.find('\n', at)) != std::string_view::npos; ++at)
            ++lines;
        benchmark::DoNotOptimize(lines);
    }
}

void decode_steps(benchmark::State& state) {
    const std::string_view text = head_trace();
    const auto lines = static_cast<std::size_t>(std::count(text.begin(), text.end(), '\n'));
    for (auto _ : state) {
        std::string_view rest = text.substr(text.find('\n') + 1);
        std::size_t steps = 0;
        for (AnyStep step; take_step(rest, step); ++steps) {
            benchmark::DoNotOptimize(step);
            rest.remove_prefix(rest.starts_with(',') ? 2 : 1);
        }
        if (steps + 3 < lines) // the header, and the lines of the end record
            state.SkipWithError("a step was not decoded");
    }
}

BENCHMARK(decode_lines)->Name("decode/lines")->Unit(benchmark::kMillisecond);
BENCHMARK(decode_steps)->Name("decode/steps")->Unit(benchmark::kMillisecond);

} // namespace
} // namespace rastertrace
