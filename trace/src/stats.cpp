// SPDX-License-Identifier: MIT
#include <rastertrace/trace/stats.h>

#include "coverage.h"

#include <rastertrace/trace/frame.h>
#include <rastertrace/trace/write_trace.h>

#include <algorithm>
#include <cstddef>
#include <string>
#include <utility>
#include <vector>

namespace rastertrace {

namespace {

/// Adds one to the count of a kind of step.
void count_step(Stats& stats, std::string kind) {
    const auto known = std::find_if(stats.count.begin(), stats.count.end(),
                                    [&kind](const auto& entry) { return entry.first == kind; });
    if (known == stats.count.end())
        stats.count.emplace_back(std::move(kind), 1);
    else
        ++known->second;
}

/// Counts a pixel step, and notes its pixel as drawn by the current primitive.
void count_pixel(Stats& stats, std::vector<DrawnPrimitive>& drawn, const StepView& step,
                 const Replay& replay) {
    const Canvas& canvas = replay.trace().canvas;
    const Index x = *step.whole("x");
    const Index y = *step.whole("y");
    if (!canvas.contains(x, y))
        return;
    ++stats.writes;
    if (stats.primitives.empty())
        return;
    ++stats.primitives.back().writes;
    stats.primitives.back().over += replay.drew_over() != 0 ? 1 : 0;
    add_pixel(drawn.back(), canvas.offset_of({static_cast<int>(x), static_cast<int>(y)}));
}

} // namespace

Stats stats_of(const Trace& trace) {
    // Step by step, what is drawn and by which primitive.
    Stats stats;
    stats.steps = trace.size();
    std::vector<DrawnPrimitive> drawn;
    Replay replay(trace);
    for (std::size_t n = 1; n <= trace.size(); ++n) {
        replay.go_to(n);
        const StepView step = trace.step(n);
        const auto kind = trace.kind_of(n);
        count_step(stats, kind ? std::string(name_of(*kind)) : step.kind_name());
        if (kind == StepKind::primitive) {
            PrimitiveStats& primitive = stats.primitives.emplace_back();
            primitive.kind = step.text("kind");
            primitive.name = step.text("name");
            drawn.push_back({.step = n, .pixels = {}});
        }
        if (kind == StepKind::skip && !stats.primitives.empty())
            stats.primitives.back().skipped = step.text("why");
        if (kind == StepKind::pixel)
            count_pixel(stats, drawn, step, replay);
    }

    // Against what should have been drawn, where all of that can be there.
    for (std::size_t i = 0; i < drawn.size(); ++i) {
        keep_each_once(drawn[i]);
        stats.primitives[i].pixels = drawn[i].pixels.size();
    }
    if (!trace.end && !drawn.empty())
        drawn.pop_back();
    if (!trace.is_partial)
        compare_with_corners(trace, drawn, stats);

    // The picture that came of it.
    const Image& picture = replay.frame().image;
    stats.canvas = picture.colors().size();
    stats.pixels = picture.drawn();
    stats.frame = frame_name(picture);
    const bool is_comparable = trace.end && !trace.end->frame.empty() && !trace.is_partial;
    stats.frame_differs = is_comparable && trace.end->frame != stats.frame;
    return stats;
}

} // namespace rastertrace
