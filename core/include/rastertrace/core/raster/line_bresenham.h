// SPDX-License-Identifier: MIT
#pragma once

// Bresenham's line: whole numbers only, one decision per pixel.
//
// Source: Bresenham 1965, in the form of the report on points and lines: d = 2 dy - dx at the
// start; if d <= 0 go straight on and add 2 dy, else go diagonally and add 2 (dy - dx). At a tie (d
// = 0) the line stays on the side it started on, so a line and its reverse may differ. With `ties:
// step` it goes straight on only if d < 0, as many drawing libraries have it. Here for all eight
// octants: dx and dy are the lengths along the major and the minor axis.
//
//     draw_bresenham({{0, 0}, {5, 2}, {}, {}}, LineRules(), canvas, FlatPainter(image, color));
//     // (0,0)(1,0)(2,1)(3,1)(4,2)(5,2)

#include <rastertrace/core/numbers/index.h>
#include <rastertrace/core/raster/bresenham_steps.h>
#include <rastertrace/core/raster/canvas.h>
#include <rastertrace/core/raster/image.h>
#include <rastertrace/core/raster/line.h>
#include <rastertrace/core/raster/sink.h>
#include <rastertrace/core/raster/steps.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>

namespace rastertrace {

/// The compass point of a step: E is x + 1, N is y + 1.
inline Move move_of(GridPoint step) {
    constexpr std::array<std::array<Move, 3>, 3> moves{{{Move::sw, Move::w, Move::nw},
                                                        {Move::s, Move::e, Move::n},
                                                        {Move::se, Move::e, Move::ne}}};
    return moves[static_cast<std::size_t>(step.x + 1)][static_cast<std::size_t>(step.y + 1)];
}

/// Draws a line; false if its only pixel is the last one, which `ends: first` leaves out. The
/// time is proportional to the pixels on the canvas. The ends must lie within +-farthest_index / 4.
template <typename Sink>
requires SinkFor<Sink, LineDecided<>, PixelPlotted<>, PixelsRejected<>>
bool draw_bresenham(const GridLine& line, const LineRules& rules, const Canvas& canvas,
                    Sink&& sink) {
    const BresenhamLine path(line.from, line.to, rules.ties);
    const Index end = path.steps() - (rules.ends == EndPixels::both ? 0 : 1);
    if (end < 0)
        return false;
    const auto pixel_at = [&path](Index i) { return path.pixel(i); };
    const StepRange steps = path.steps_on(canvas, end);
    reject_before(steps, end, pixel_at, sink);
    if (steps.is_empty())
        return true;

    GridPoint at = path.pixel(steps.first);
    std::int64_t d = path.d(steps.first);
    for (Index i = steps.first;; ++i) {
        const Color color = color_on_line(line, rules, at, i, path.steps());
        const Pixel pixel{static_cast<int>(at.x), static_cast<int>(at.y)};
        sink(PixelPlotted<>{.x = pixel.x, .y = pixel.y, .color = color});
        if (i == steps.last)
            break;

        // Straight on, or diagonally?
        const bool goes_straight = path.goes_straight(d);
        const GridPoint step = goes_straight ? path.straight() : path.diagonal();
        sink(LineDecided<>{.x = pixel.x, .y = pixel.y, .d = d, .move = move_of(step)});
        d += goes_straight ? path.d_straight() : path.d_diagonal();
        at = {at.x + step.x, at.y + step.y};
    }
    reject_behind(steps, end, pixel_at, sink);
    return true;
}

} // namespace rastertrace
