// SPDX-License-Identifier: MIT
// Two traces compared, against counting the lines of both: `diff/lines`, `diff/equal` (another file with the same
// bytes) and `diff/one-step` (one digit differs in the middle), on a head of 38,080 triangles.

#include "trace_file.h"

#include <rastertrace/trace/compare/diff.h>

#include <benchmark/benchmark.h>

#include <cstring>
#include <fstream>
#include <iterator>
#include <string>
#include <utility>
#include <vector>

namespace rastertrace {
namespace {

/// The head's trace once more; with one pixel of a row in the middle at another place, if so asked.
const std::string& copy_path(bool is_changed) {
    static const TemporaryFile equal("rastertrace-bench-equal.json");
    static const TemporaryFile changed("rastertrace-bench-changed.json");
    static const bool are_written = [] {
        std::ifstream file(head_trace_path(), std::ios::binary);
        std::string text{std::istreambuf_iterator<char>(file), {}};
        std::ofstream(equal.path(), std::ios::binary) << text;
        const std::size_t row = text.find("\"step\":\"scanline\",\"y\":", text.size() / 2);
        char& digit = text[text.find(",\"from\":", row) + std::strlen(",\"from\":")];
        digit = digit == '-' ? '1' : '9';
        std::ofstream(changed.path(), std::ios::binary) << text;
        return true;
    }();
    static const std::string paths[]{equal.path(), changed.path()};
    return paths[are_written && is_changed ? 1 : 0];
}

/// memchr from line to line.
std::size_t lines_by_memchr(const std::string& path) {
    std::ifstream file(path, std::ios::binary);
    std::vector<char> block(1 << 17);
    std::size_t lines = 0;
    for (;;) {
        file.read(block.data(), static_cast<std::streamsize>(block.size()));
        const auto size = static_cast<std::size_t>(file.gcount());
        if (size == 0)
            return lines;
        const char* at = block.data();
        const char* const end = at + size;
        while (const auto* const newline = static_cast<const char*>(
                   std::memchr(at, '\n', static_cast<std::size_t>(end - at)))) {
            ++lines;
            at = newline + 1;
        }
    }
}

void diff_lines(benchmark::State& state) {
    const std::string& a = head_trace_path();
    const std::string& b = copy_path(false);
    for (auto _ : state)
        benchmark::DoNotOptimize(lines_by_memchr(a) + lines_by_memchr(b));
}

Trace opened(const std::string& path) {
    return std::move(read_trace(read_source(path).value()).value());
}

void diff_traces(benchmark::State& state, bool is_changed) {
    const std::string& a = head_trace_path();
    const std::string& b = copy_path(is_changed);
    for (auto _ : state) {
        const TraceDiff found = diff(opened(a), opened(b), {});
        if (found.is_same == is_changed)
            state.SkipWithError("the difference was not found");
    }
}

BENCHMARK(diff_lines)->Name("diff/lines")->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(diff_traces, equal, false)->Name("diff/equal")->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(diff_traces, one_step, true)
    ->Name("diff/one-step")
    ->Unit(benchmark::kMillisecond);

} // namespace
} // namespace rastertrace
