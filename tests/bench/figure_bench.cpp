// SPDX-License-Identifier: MIT
// Figures. `figures/row/*`: a row of the worked triangle, as a frame of text (the baseline), as an SVG, as a PNG.
// `figures/grid/*`: a circle of triangles on 64 x 64 pixels of 8 units with a grid, some 550 x 600 pixels; and on 512 x 512
// pixels of one unit. `figures/gif/1000`: an animation of 1,000 frames.

#include "drawn_trace.h"

#include "frames/frame_text.h"
#include <rastertrace/figures/bitmap.h>
#include <rastertrace/figures/figure.h>
#include <rastertrace/figures/gif.h>
#include <rastertrace/figures/png.h>
#include <rastertrace/figures/svg.h>
#include <rastertrace/trace/record/traced_steps.h>

#include <benchmark/benchmark.h>

#include <string>
#include <vector>

namespace rastertrace {
namespace {

const Trace& first_triangle() {
    static const Trace trace = drawn_trace({"scene.json", R"({"canvas": {"width": 17, "height": 14},
        "vertices": {"A": [2, 5], "B": [-4, -3], "C": [5, -3]}, "triangles": ["ABC"],
        "method": {"scalar": "exact"}})"});
    return trace;
}

/// Its row y = 2.
FigureFrame row_frame() {
    const Trace& trace = first_triangle();
    std::size_t n = 1;
    while (trace.kind_of(n) != StepKind::scanline || y_in(trace.step(n)) != 2)
        ++n;
    return {.steps = {n, end_of(trace, n)}};
}

/// Four triangles around the middle of a square canvas.
Trace square_trace(int side) {
    const std::string size = std::to_string(side);
    const std::string half = std::to_string(side / 2 - 1);
    return drawn_trace({"scene.json", R"({"canvas": {"width": )" + size + R"(, "height": )" + size +
                                          R"(},
        "vertices": {"O": [0, 0], "N": [0, )" +
                                          half + R"(], "E": [)" + half + R"(, 0],
                     "S": [0, -)" + half + R"(], "W": [-)" +
                                          half + R"(, 0]},
        "triangles": ["ONE", "OES", "OSW", "OWN"], "method": {"fill": "top-left"}})"});
}

Drawing whole(const Trace& trace, double cell) {
    FigureMaker maker(trace, {{.steps = {0, trace.size()}}},
                      {.with = {FigurePart::grid}, .cell = cell});
    return maker.figure(0);
}

std::string png_bytes(const Drawing& drawing, double scale) {
    return png_of(bitmap_of(drawing, Theme::light, scale)).value();
}

void row_as_text(benchmark::State& state) {
    const FigureFrame frame = row_frame();
    for (auto _ : state) {
        Replay replay(first_triangle());
        replay.go_to(frame.steps.last);
        benchmark::DoNotOptimize(frame_text(
            replay, {.caption = {}, .first_step = frame.steps.first, .last_step = frame.steps.last},
            {}));
    }
}

void row_as_svg(benchmark::State& state) {
    for (auto _ : state) {
        FigureMaker maker(first_triangle(), {row_frame()}, {});
        benchmark::DoNotOptimize(svg_of(maker.figure(0), Theme::automatic).value());
    }
}

void row_as_png(benchmark::State& state) {
    for (auto _ : state) {
        FigureMaker maker(first_triangle(), {row_frame()}, {});
        benchmark::DoNotOptimize(png_bytes(maker.figure(0), 2));
    }
}

void grid_as_png(benchmark::State& state, int side, double cell) {
    const Trace trace = square_trace(side);
    for (auto _ : state)
        benchmark::DoNotOptimize(png_bytes(whole(trace, cell), 1));
}

/// The first 1,000 pixels that are drawn, a frame each.
void gif_of_1000(benchmark::State& state) {
    const Trace trace = square_trace(64);
    std::vector<FigureFrame> frames;
    for (std::size_t n = 1; n <= trace.size() && frames.size() < 1000; ++n)
        if (trace.kind_of(n) == StepKind::pixel)
            frames.push_back({.steps = {n, n}});
    for (auto _ : state) {
        FigureMaker maker(trace, frames, {.cell = 5, .caption = ""});
        benchmark::DoNotOptimize(
            gif_of(frames.size(),
                   [&](std::size_t i) { return bitmap_of(maker.figure(i), Theme::light, 1); }, {})
                .value());
    }
    state.counters["frames"] = static_cast<double>(frames.size());
}

const int registered = [] {
    benchmark::RegisterBenchmark("figures/row/text", row_as_text)->Unit(benchmark::kMillisecond);
    benchmark::RegisterBenchmark("figures/row/svg", row_as_svg)->Unit(benchmark::kMillisecond);
    benchmark::RegisterBenchmark("figures/row/png", row_as_png)->Unit(benchmark::kMillisecond);
    benchmark::RegisterBenchmark("figures/grid/64", grid_as_png, 64, 8.0)
        ->Unit(benchmark::kMillisecond);
    benchmark::RegisterBenchmark("figures/grid/512", grid_as_png, 512, 1.0)
        ->Unit(benchmark::kMillisecond);
    benchmark::RegisterBenchmark("figures/gif/1000", gif_of_1000)
        ->Unit(benchmark::kMillisecond)
        ->Iterations(1);
    return 0;
}();

} // namespace
} // namespace rastertrace
