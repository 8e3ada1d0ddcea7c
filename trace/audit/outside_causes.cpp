// SPDX-License-Identifier: MIT
#include "outside_causes.h"

#include "positions.h"

#include <rastertrace/trace/record/traced_steps.h>
#include <rastertrace/trace/tell/step_text.h>

#include <algorithm>

namespace rastertrace {

OutsideCauses::OutsideCauses(const Trace& trace, const CanvasSamples& grid)
    : steps_(trace), size_(trace.size()), grid_(grid), has_floats_(has_floats(trace)) {
    const std::string all = trace.method_value("rounding");
    const std::string rounding = all.empty() ? "rounding" : all.substr(0, all.find('+'));
    left_of_edge_ = rounding + " takes the pixel left of the edge";
    right_of_edge_ = rounding + " takes the pixel right of the edge";
}

std::vector<PixelCause> OutsideCauses::of(const std::vector<std::uint32_t>& outside,
                                          std::size_t step) {
    std::vector<PixelCause> causes;
    std::vector<bool> has_cause(outside.size());
    std::size_t missing = outside.size();
    decisive_ = StepKind::primitive;
    for (std::size_t n = step + 1; n <= size_ && missing > 0; ++n) {
        const auto kind = steps_.kind_of(n);
        if (kind == StepKind::primitive)
            break;
        if (kind == StepKind::scanline || kind == StepKind::sample || kind == StepKind::ray)
            take_decisive(n, *kind);
        if (kind != StepKind::pixel && kind != StepKind::depth)
            continue;
        const StepView about = steps_.step(n);
        const Index x = *x_in(about);
        const Index y = *y_in(about);
        if (!grid_.canvas.contains(x, y))
            continue;
        const Pixel pixel{static_cast<int>(x), static_cast<int>(y)};
        const auto offset = static_cast<std::uint32_t>(grid_.canvas.offset_of(pixel));
        const auto place = std::lower_bound(outside.begin(), outside.end(), offset);
        if (place == outside.end() || *place != offset)
            continue;
        const auto i = static_cast<std::size_t>(place - outside.begin());
        if (has_cause[i]) // the pixel comes again
            continue;
        has_cause[i] = true;
        --missing;
        const std::string_view cause = cause_of(x);
        const auto known = std::find_if(causes.begin(), causes.end(),
                                        [&](const auto& one) { return one.cause == cause; });
        ++(known == causes.end() ? causes.emplace_back(PixelCause{std::string(cause), 0}) : *known)
              .pixels;
    }
    return causes;
}

/// Takes a step that found the ends of a row, or the pixel itself.
void OutsideCauses::take_decisive(std::size_t n, StepKind kind) {
    decisive_ = kind;
    if (kind != StepKind::scanline)
        return;
    const auto row = steps_.step(n).as<ScanlineStep>();
    left_ = coordinate_in(row.left.json(), has_floats_);
    right_ = coordinate_in(row.right.json(), has_floats_);
}

/// Why a pixel lies outside, by the last such step.
std::string_view OutsideCauses::cause_of(Index x) const {
    if (decisive_ == StepKind::sample)
        return "the weights of the sample were rounded";
    if (decisive_ == StepKind::ray)
        return "a line of the fan leaves the triangle";
    if (decisive_ != StepKind::scanline)
        return "no step says why";
    const Coordinate sample = grid_.x_of(x);
    if (left_ && sample < *left_)
        return left_of_edge_;
    if (right_ && sample > *right_)
        return right_of_edge_;
    return "the ends of the row, as calculated, lie outside";
}

} // namespace rastertrace
