// SPDX-License-Identifier: MIT
#pragma once

// Why pixels were drawn outside of their triangle, by the steps that led to them.
//
//     OutsideCauses causes(trace, grid);
//     causes.of({39, 55}, 1);  // {{"floor takes the pixel left of the edge", 2}}

#include "screen_point.h"
#include "stats.h"
#include "triangle_samples.h"

#include <rastertrace/trace/record/trace.h>

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace rastertrace {

/// Not for two threads at once.
class OutsideCauses {
public:
    /// The grid has to outlive this.
    OutsideCauses(const Trace& trace, const CanvasSamples& grid);

    /// The causes of the pixels that the primitive of a step drew outside; `outside` has their places, in ascending order.
    std::vector<PixelCause> of(const std::vector<std::uint32_t>& outside, std::size_t step);

private:
    void take_decisive(std::size_t n, StepKind kind);
    std::string_view cause_of(Index x) const;

    StepReader steps_;
    std::size_t size_;
    const CanvasSamples& grid_;
    bool has_floats_;
    std::string left_of_edge_;
    std::string right_of_edge_;

    /// The kind of the last step that found the ends of a row, or the pixel itself; `primitive` in front of the first.
    StepKind decisive_ = StepKind::primitive;
    std::optional<Coordinate> left_; ///< the ends of the row
    std::optional<Coordinate> right_;
};

} // namespace rastertrace
