// SPDX-License-Identifier: MIT
#pragma once

// The line of a digital differential analyzer (DDA): y once, then one addition a step.
//
//     y = y0 + m (x - x0)    on the first step, then    y += m
//
// Source: the textbooks' DDA.

#include <rastertrace/core/numbers/scalar.h>
#include <rastertrace/core/raster/canvas.h>
#include <rastertrace/core/raster/line_sampling.h>
#include <rastertrace/core/raster/sink.h>
#include <rastertrace/core/raster/steps.h>

namespace rastertrace {

/// Draws a line between any two points; false if it has no pixel to draw (SampledLine::last_step).
/// The time is proportional to the canvas. On a steep line x and y are exchanged.
template <typename Scalar, typename Sink>
requires SinkFor<Sink, LineSampled<Scalar>, PixelPlotted<>, PixelsRejected<>>
bool draw_dda_line(const Segment<Scalar>& segment, const SampleOffset<Scalar>& offset,
                   const LineSampling& sampling, const Canvas& canvas, Sink&& sink) {
    const SampledLine<Scalar> line(segment, offset, sampling, canvas);
    if (line.last_step() < 0)
        return false;

    const auto y_at = [&line](Index step) {
        return linear(line.across_from, line.slope, line.sample_along(step), line.along_from);
    };
    const auto pixel_at = [&](Index step) { return line.pixel(step, y_at(step)); };

    const StepRange steps = line.steps_on_canvas();
    reject_before(steps, line.last_step(), pixel_at, sink);

    Scalar m = line.goes_back ? Scalar(-line.slope) : line.slope;
    Scalar y{};
    for (Index i = steps.first; i <= steps.last; ++i) {
        if (i == steps.first) {
            y = y_at(i);
            write_over_denominator_of(y, m);
        } else {
            y += m;
        }
        line.plot(i, y, sink);
    }
    reject_behind(steps, line.last_step(), pixel_at, sink);
    return true;
}

} // namespace rastertrace
