// SPDX-License-Identifier: MIT
#pragma once

// The naive line of the textbooks: y from the equation of the line at every step, rounded.
//
//     y = m x + b,   m = dy/dx,   b = y0 - m x0
//
// Source: the report on points and lines, with y = m x0 + b put right.

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
bool draw_naive_line(const Segment<Scalar>& segment, const SampleOffset<Scalar>& offset,
                     const LineSampling& sampling, const Canvas& canvas, Sink&& sink) {
    const SampledLine<Scalar> line(segment, offset, sampling, canvas);
    if (line.last_step() < 0)
        return false;

    const Scalar& m = line.slope;
    const Scalar b = line.across_from - m * line.along_from;
    const auto y_at = [&](Index step) { return Scalar(m * line.sample_along(step) + b); };
    const auto pixel_at = [&](Index step) { return line.pixel(step, y_at(step)); };

    const StepRange steps = line.steps_on_canvas();
    reject_before(steps, line.last_step(), pixel_at, sink);
    for (Index i = steps.first; i <= steps.last; ++i)
        line.plot(i, y_at(i), sink);
    reject_behind(steps, line.last_step(), pixel_at, sink);
    return true;
}

} // namespace rastertrace
