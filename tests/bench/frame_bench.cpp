// SPDX-License-Identifier: MIT
// Frames as text. `frames/head/VIEW`: a trace of a head of 38,080 triangles on 512 x 512 pixels, played to its
// end and shown; the baseline is the plain view. `frames/overview`: a canvas of 16384 x 4096 in one page, and
// the memory that this takes.

#include "drawn_trace.h"

#include "frames/frame_text.h"
#include <rastertrace/trace/tell/view.h>

#include <benchmark/benchmark.h>

#include <sys/resource.h>

#include <filesystem>
#include <string>
#include <string_view>

namespace rastertrace {
namespace {

const Trace& head() {
    static const Trace trace = drawn_trace({RASTERTRACE_HEAD ".json", R"({
  "canvas": {"width": 512, "height": 512},
  "meshes": [{"obj": ")" + std::filesystem::path(RASTERTRACE_HEAD).filename().string() +
                                                                          R"(",
    "model": [{"rotate": {"axis": "y", "degrees": -25}}, {"rotate": {"axis": "x", "degrees": 10}}]}],
  "camera": {"position": [0, 0, 6], "look_at": [0, 0, 0], "up": [0, 1, 0]},
  "projection": {"type": "frustum", "fov_y": 32, "near": 1, "far": 10},
  "light": {"direction": [-1, 1, 2]},
  "method": {"cull": "back", "depth": "inverse-z", "shade": "lambert"}})"});
    return trace;
}

/// The last frame of a trace.
std::string last_frame(const Trace& trace, View view, bool is_overview) {
    Replay replay(trace, parts_for(view, trace));
    replay.go_to(trace.size());
    return frame_text(replay,
                      {.caption = {},
                       .first_step = trace.size(),
                       .last_step = trace.size(),
                       .view = view,
                       .is_overview = is_overview},
                      {});
}

void show_head(benchmark::State& state, View view) {
    const Trace& trace = head();
    for (auto _ : state)
        benchmark::DoNotOptimize(last_frame(trace, view, false));
}

/// The most memory that this process has had, in bytes.
double peak_memory() {
    rusage usage{};
    ::getrusage(RUSAGE_SELF, &usage);
    return static_cast<double>(usage.ru_maxrss) * 1024;
}

void show_overview(benchmark::State& state) {
    const Trace trace = drawn_trace({RASTERTRACE_HEAD ".json", R"({
  "canvas": {"width": 16384, "height": 4096},
  "vertices": {"A": [-8000, -2000], "B": [8000, -1500], "C": [-8000, -1990]},
  "triangles": ["ABC"]})"});
    for (auto _ : state)
        benchmark::DoNotOptimize(last_frame(trace, default_view(trace), true));
    state.counters["memory"] = peak_memory();
}

const bool are_registered = [] {
    for (const std::string_view name : view_names())
        benchmark::RegisterBenchmark(("frames/head/" + std::string(name)).c_str(), show_head,
                                     *view_named(name))
            ->Unit(benchmark::kMillisecond);
    benchmark::RegisterBenchmark("frames/overview", show_overview)->Unit(benchmark::kMillisecond);
    return true;
}();

} // namespace
} // namespace rastertrace
