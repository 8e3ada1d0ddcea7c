// SPDX-License-Identifier: MIT
#include "redo_beside.h"

#include <rastertrace/core/raster/rounding.h>
#include <rastertrace/trace/tell/told_samples.h>

#include <algorithm>

namespace rastertrace {

namespace {

/// The pixels of a row, if the header tells how its ends become them.
std::optional<SpanRounding> rounding_of(const ToldMethod& rules, bool is_triangle) {
    if (is_triangle && rules.triangles.fill == Fill::top_left)
        return SpanRounding{.rounding = Rounding::half_open};
    return rules.says("rounding") ? std::optional(span_rounding(rules.triangles)) : std::nullopt;
}

} // namespace

void redo_beside(const Trace& trace, std::size_t first, std::size_t last, Findings& findings) {
    const auto primitive = trace.step(first).as<PrimitiveStep>();
    const auto offset = told_samples(trace).of(primitive.kind);
    const auto rounding = rounding_of(trace.method, primitive.kind == PrimitiveKind::triangle);
    std::optional<ScanlineStep> row;
    const auto redo = [&](std::size_t n, const StepView& step, StepKind kind) {
        if (kind == StepKind::scanline) {
            row = step.as<ScanlineStep>();
            const Rational left = offset.in_columns(exactly(row->left));
            const Rational right = offset.in_columns(exactly(row->right));
            if (rounding) {
                findings.expect(n, first_pixel(left, *rounding), row->from, "scanline: from");
                findings.expect(n, last_pixel(right, *rounding), row->to, "scanline: to");
            }
        } else if (kind == StepKind::sample && trace.method.says("fill")) {
            const auto sample = step.as<SampleStep>();
            const auto weights = numbers_of<Rational>(sample.weights);
            const bool is_inside = std::all_of(weights.begin(), weights.end(),
                                               [](const Rational& one) { return one >= 0; });
            findings.expect(n, is_inside, sample.inside.is_true(), "sample: inside");
        } else if (kind == StepKind::pixel && row) {
            const auto pixel = step.as<PixelStep>();
            findings.expect(n, true,
                            row->y == pixel.y && row->from <= pixel.x && pixel.x <= row->to,
                            "pixel: x", " in its row");
        }
    };
    for (std::size_t n = first; n <= last; ++n)
        try {
            if (const auto kind = trace.kind_of(n))
                redo(n, trace.step(n), *kind);
        } catch (const NotTold&) {
        }
}

} // namespace rastertrace
