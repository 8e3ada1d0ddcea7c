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

/// Draws a line between any two points; false if it has no pixel to draw (SampledLine::has_pixels). Time
/// follows the canvas. x and y change places where the line is steep.
template <typename Scalar, typename Sink>
requires SinkFor<Sink, LineSampled<Scalar>, PixelPlotted, PixelsRejected>
bool draw_dda_line(const Segment<Scalar>& segment, const LineSampling& sampling,
                   const Canvas& canvas, Sink&& sink) {
    const SampledLine<Scalar> line(segment, sampling, canvas);
    if (!line.has_pixels())
        return false;

    const auto y_at = [&line](Index x) {
        return linear(line.across_from, line.slope, scalar_from<Scalar>(x), line.along_from);
    };
    const auto steps = line.steps_on_canvas();
    line.reject_before(steps, y_at, sink);

    Scalar m = line.goes_back ? Scalar(-line.slope) : line.slope;
    Scalar y{};
    for (Index i = steps.begin; i <= steps.end; ++i) {
        if (i == steps.begin) {
            y = y_at(line.along(i));
            write_over_denominator_of(y, m);
        } else {
            y += m;
        }
        line.plot(i, y, sink);
    }
    line.reject_behind(steps, y_at, sink);
    return true;
}

} // namespace rastertrace
