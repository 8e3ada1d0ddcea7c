// SPDX-License-Identifier: MIT
#pragma once

// How a trace is written, and which of its steps.
//
//     write_trace(scene, {.layout = TraceLayout::jsonl, .filter = {.primitive = "ABC"}}, output);

#include "step_kind.h"

#include <rastertrace/core/raster/canvas.h>

#include <optional>
#include <string>
#include <vector>

namespace rastertrace {

/// How the lines of a trace hang together.
enum class TraceLayout {
    json,  ///< one JSON document, one step per line
    jsonl, ///< one JSON value per line
};

/// A rectangle of pixels, borders included.
struct Region {
    int x0 = 0;
    int y0 = 0;
    int x1 = 0;
    int y1 = 0;

    bool has_row(Index y) const { return y0 <= y && y <= y1; }
    bool meets(Index from, Index to) const { return from <= x1 && x0 <= to; }
};

/// Which steps are written.
struct StepFilter {
    std::optional<std::vector<StepKind>> only = {}; ///< these kinds; all, if not said
    std::optional<Region> region =
        {}; ///< of the steps that name pixels or rows, those that meet it
    std::optional<std::string> primitive = {}; ///< those of this primitive and its parts
};

/// How the lines of a trace are laid out, and which steps it has.
struct TraceOptions {
    TraceLayout layout = TraceLayout::json;
    StepFilter filter;
};

} // namespace rastertrace
