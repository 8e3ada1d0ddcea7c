// SPDX-License-Identifier: MIT
#pragma once

// The working of a step, in a test.

#include "claims_support.h"
#include "traces.h"

#include <rastertrace/trace/record/replay.h>
#include <rastertrace/trace/record/traced_steps.h>
#include <rastertrace/trace/tell/step_text.h>
#include <rastertrace/trace/tell/working.h>

#include <gtest/gtest.h>

#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace rastertrace {

inline Trace example(const std::string& name, std::optional<Depth> depth = {}) {
    Scene scene = scene_in(example_text(name));
    if (depth)
        scene.method.depth = *depth;
    return trace_of(scene);
}

using Working = std::vector<std::string>;

/// The first step of which `is_meant` is true.
inline std::size_t step_of(const Trace& trace,
                           const std::function<bool(const StepView&)>& is_meant) {
    for (std::size_t n = 1; n <= trace.size(); ++n)
        if (is_meant(trace.step(n)))
            return n;
    ADD_FAILURE() << "no such step";
    return 0;
}

inline Working working(const Trace& trace, std::size_t n) {
    Replay replay(trace);
    replay.go_to(n);
    return working_of(replay);
}

/// The working of the first step of a kind that has these numbers as x and y, or this name.
inline Working working(const Trace& trace, StepKind kind, int x, int y) {
    return working(trace, step_of(trace, [&](const StepView& step) {
                       return step.kind() == kind && x_in(step).value_or(x) == x &&
                              y_in(step).value_or(y) == y;
                   }));
}
inline Working working(const Trace& trace, StepKind kind, std::string_view name,
                       std::string_view space = "") {
    return working(trace, step_of(trace, [&](const StepView& step) {
                       return step.kind() == kind &&
                              (kind == StepKind::edge ? step.as<EdgeStep>().edge == name
                                                      : name_in(step) == name) &&
                              (kind != StepKind::vertex || step.as<VertexStep>().space == space);
                   }));
}

/// The trace of a line between two colors; coordinates as typed.
inline Trace colored_line(const std::string& a, const std::string& b, const std::string& method) {
    return trace_of(scene_in(R"({"canvas": {"width": 32, "height": 32, "origin": "bottom-left"},
"vertices": {"A": [)" + a + R"(], "B": [)" +
                             b + R"(]}, "colors": {"A": "#ff8000", "B": "#0040ff"},
"lines": ["AB"], "method": {)" +
                             method + "}}"));
}

} // namespace rastertrace
