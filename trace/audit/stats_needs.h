// SPDX-License-Identifier: MIT
#pragma once

// What the findings of stats need and a trace lacks, found step by step.
//
//     StatsNeeds needs(header);
//     needs.begin(primitive, 1);
//     needs.add(StepKind::pixel, 2);
//     needs.close();
//     needs.unjudged();  // {{holes, twice, outside}, "expected \"at\", ..., found none"}
//
// Holes, pixels drawn twice and pixels outside are judged by the corners of triangles. A triangle
// that drew nothing and was skipped or clipped needs none. Rows are judged by scanline steps; a
// fill of another kind tells its samples or its rays.

#include "screen_point.h"
#include "stats.h"

#include <rastertrace/trace/record/trace.h>
#include <rastertrace/trace/record/traced_steps.h>

#include <array>
#include <cstddef>
#include <optional>
#include <string>
#include <vector>

namespace rastertrace {

class StatsNeeds {
public:
    /// `header` is asked for its numbers and for what was left out.
    explicit StatsNeeds(const Trace& header) : header_(header) {}

    /// Takes step `number` of the trace: a primitive, or one of another kind.
    void begin(const PrimitiveStep& step, std::size_t number);
    void add(StepKind kind, std::size_t number);

    /// Behind the last step.
    void close();

    /// The positions of the current primitive; `nullopt` if its step does not give three, exactly.
    const std::optional<std::array<ScreenPoint, 3>>& corners() const { return primitive_.corners; }

    /// What cannot be judged, and what is lacking first.
    std::vector<Unjudged> unjudged() const;

private:
    /// The primitive that the steps belong to.
    struct Primitive {
        bool is_begun = false; ///< false in front of the first
        std::optional<std::array<ScreenPoint, 3>> corners = {};
        std::string lacks = {};        ///< of what corners need; "" if it has all of it
        bool is_judged = true;         ///< not of lines, points, outlines, and of what only hides
        bool is_undrawn = false;       ///< it was skipped or clipped
        std::size_t first_pixel = 0;   ///< the step of it
        bool tells_its_pixels = false; ///< by rows, samples or rays
    };

    const Trace& header_;
    Primitive primitive_;
    std::string lacks_of_corners_;
    std::string lacks_of_rows_;
};

} // namespace rastertrace
