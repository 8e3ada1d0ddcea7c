// SPDX-License-Identifier: MIT
#include "steps_of_pixel.h"

#include <rastertrace/trace/record/traced_steps.h>
#include <rastertrace/trace/tell/step_text.h>

#include <utility>

namespace rastertrace {

void StepsOfPixel::take(const StepView& step, std::optional<StepKind> kind, std::size_t number) {
    if (!kind) {
        if (is_at_pixel(step))
            keep(step, kind, number);
        return;
    }
    switch (*kind) {
    case StepKind::vertex: {
        // A depth is worked out on the plane of the face, in the camera's space; a color by the w of clip space.
        const auto space = step.as<VertexStep>().space;
        if (space != Space::canonical && space != Space::screen)
            keep(step, kind, number);
        return;
    }
    case StepKind::primitive:
        keep(row_);
        begin_primitive(step);
        break;
    case StepKind::edge:
        is_x_major_ = is_x_major_octant(step.as<EdgeStep>().octant);
        ray_ = {};
        begin_line();
        break;
    case StepKind::ray:
        ray_ = waiting(step, *kind, number);
        begin_line();
        return;
    case StepKind::scanline:
        return take_scanline(step, number);
    case StepKind::along:
    case StepKind::decide:
        return take_reason(step, *kind, number);
    case StepKind::sample:
        if (is_at_pixel(step))
            keep(step, kind, number);
        return;
    case StepKind::crossings:
        if (y_in(step) == pixel_.y)
            keep(step, kind, number);
        return;
    case StepKind::depth:
    case StepKind::pixel:
    case StepKind::reject:
        return take_fragment(step, *kind, number);
    default:
        break;
    }
    keep(step, kind, number);
}

StepsOfPixel::Waiting StepsOfPixel::waiting(const StepView& step, StepKind kind,
                                            std::size_t number) const {
    const std::string_view json = step.json();
    return excerpt_.is_in_file(json) ? Waiting{json, {}, kind, number}
                                     : Waiting{{}, std::string(json), kind, number};
}

void StepsOfPixel::begin_primitive(const StepView& step) {
    const auto primitive = step.as<PrimitiveStep>();
    is_line_ = !is_filled(primitive.kind);
    is_point_ = primitive.kind == PrimitiveKind::point;
    is_x_major_ = is_x_major_octant(primitive.octant);
    has_row_ = false;
    ray_ = {};
    begin_line();
}

void StepsOfPixel::begin_line() {
    reason_before_ = reason_ = {};
    is_decided_ = false;
}

/// The row of the pixel, the one before it, and the first and the last of the primitive.
void StepsOfPixel::take_scanline(const StepView& step, std::size_t number) {
    if (!has_row_ || y_in(step) == pixel_.y)
        keep(step, StepKind::scanline, number);
    else
        row_ = waiting(step, StepKind::scanline, number);
    has_row_ = true;
}

void StepsOfPixel::take_reason(const StepView& step, StepKind kind, std::size_t number) {
    reason_before_ = std::move(reason_);
    reason_ = waiting(step, kind, number);
    if (is_decided_)
        keep(reason_);
    is_decided_ = false;
}

/// Of a line, also where it is in the pixel's column or row, and what of it the canvas does not have.
void StepsOfPixel::take_fragment(const StepView& step, StepKind kind, std::size_t number) {
    const bool is_of_pixel = is_line_                   ? shares_line(step, kind)
                             : kind == StepKind::reject ? covers(step, pixel_)
                                                        : is_at_pixel(step);
    if (!is_of_pixel)
        return;
    keep(row_);
    keep(ray_);
    keep(reason_before_);
    is_decided_ = is_decided_ || reason_.kind == StepKind::decide;
    keep(reason_);
    keep(step, kind, number);
}

bool StepsOfPixel::is_at_pixel(const StepView& step) const {
    return y_in(step) == pixel_.y && x_in(step) == pixel_.x;
}

bool StepsOfPixel::shares_line(const StepView& step, StepKind kind) const {
    const auto is_run = [&step] {
        const auto reject = step.as<RejectStep>();
        return reject.to_x || reject.to_y;
    };
    if (is_point_ || (kind == StepKind::reject && is_run()))
        return true;
    const bool is_in_column = x_in(step) == pixel_.x;
    const bool is_in_row = y_in(step) == pixel_.y;
    return is_x_major_ ? (*is_x_major_ ? is_in_column : is_in_row) : is_in_column || is_in_row;
}

void StepsOfPixel::keep(const StepView& step, std::optional<StepKind> kind, std::size_t number) {
    keep(row_);
    excerpt_.add_to_excerpt(step, kind, number);
}

void StepsOfPixel::keep(Waiting& waiting) {
    if (waiting.number != 0)
        excerpt_.add_to_excerpt(StepView(waiting.copy.empty() ? waiting.in_file : waiting.copy),
                                waiting.kind, waiting.number);
    waiting.number = 0;
}

Trace StepsOfPixel::finish() && {
    keep(row_);
    return std::move(excerpt_);
}

} // namespace rastertrace
