// SPDX-License-Identifier: MIT
#include "steps_of_pixel.h"

#include <rastertrace/trace/record/traced_steps.h>
#include <rastertrace/trace/tell/step_text.h>

#include <utility>

namespace rastertrace {

void StepsOfPixel::take(std::size_t number) {
    const StepView step = trace_.step(number);
    const auto kind = step.kind();
    if (!kind) {
        if (is_at_pixel(step))
            keep(number);
        return;
    }
    switch (*kind) {
    case StepKind::vertex: {
        // A depth is worked out on the plane of the face, in the camera's space; a color by the w of clip space.
        const auto space = step.as<VertexStep>().space;
        if (space != Space::canonical && space != Space::screen)
            keep(number);
        return;
    }
    case StepKind::primitive:
        keep_waiting(row_);
        begin_primitive(step);
        break;
    case StepKind::edge:
        is_x_major_ = is_x_major_octant(step.as<EdgeStep>().octant);
        ray_ = 0;
        begin_line();
        break;
    case StepKind::ray:
        ray_ = number;
        begin_line();
        return;
    case StepKind::scanline:
        return take_scanline(step, number);
    case StepKind::along:
    case StepKind::decide:
        return take_reason(number);
    case StepKind::sample:
        if (is_at_pixel(step))
            keep(number);
        return;
    case StepKind::crossings:
        if (y_in(step) == pixel_.y)
            keep(number);
        return;
    case StepKind::depth:
    case StepKind::pixel:
    case StepKind::reject:
        return take_fragment(step, *kind, number);
    default:
        break;
    }
    keep(number);
}

void StepsOfPixel::begin_primitive(const StepView& step) {
    const auto primitive = step.as<PrimitiveStep>();
    is_line_ = !is_filled(primitive.kind);
    is_point_ = primitive.kind == PrimitiveKind::point;
    is_x_major_ = is_x_major_octant(primitive.octant);
    has_row_ = false;
    ray_ = 0;
    begin_line();
}

void StepsOfPixel::begin_line() {
    reason_before_ = reason_ = 0;
    is_decision_ = is_decided_ = false;
}

/// The row of the pixel, the one before it, and the first and the last of the primitive.
void StepsOfPixel::take_scanline(const StepView& step, std::size_t number) {
    if (!has_row_ || y_in(step) == pixel_.y)
        keep(number);
    else
        row_ = number;
    has_row_ = true;
}

void StepsOfPixel::take_reason(std::size_t number) {
    reason_before_ = std::exchange(reason_, number);
    is_decision_ = trace_.kind_of(number) == StepKind::decide;
    if (is_decided_)
        keep_waiting(reason_);
    is_decided_ = false;
}

/// Of a line, also where it is in the pixel's column or row, and what of it the canvas does not have.
void StepsOfPixel::take_fragment(const StepView& step, StepKind kind, std::size_t number) {
    const bool is_of_pixel = is_line_                   ? shares_line(step, kind)
                             : kind == StepKind::reject ? covers(step, pixel_)
                                                        : is_at_pixel(step);
    if (!is_of_pixel)
        return;
    keep_waiting(row_);
    keep_waiting(ray_);
    keep_waiting(reason_before_);
    is_decided_ = is_decided_ || is_decision_;
    keep_waiting(reason_);
    keep(number);
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

void StepsOfPixel::keep(std::size_t number) {
    keep_waiting(row_);
    excerpt_.add_to_excerpt(trace_.number_of(number));
}

void StepsOfPixel::keep_waiting(std::size_t& waiting) {
    if (waiting != 0)
        excerpt_.add_to_excerpt(trace_.number_of(waiting));
    waiting = 0;
}

Trace StepsOfPixel::finish() && {
    keep_waiting(row_);
    return std::move(excerpt_);
}

} // namespace rastertrace
