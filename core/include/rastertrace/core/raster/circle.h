// SPDX-License-Identifier: MIT
#pragma once

// The midpoint circle: whole numbers only, one decision for each column of an octant.
//
// Source: Bresenham 1977, in the form of Hearn and Baker, Computer Graphics. Around (0, 0), the
// octant from (0, r) to the diagonal goes from pixel to pixel to the east, or to the south-east.
// The midpoint between these two, (x + 1, y - 1/2), decides: if it lies inside of the circle, east.
//
//     d = (x + 1)^2 + (y - 1/2)^2 - r^2 - 1/4:    1 - r at the start
//     d < 0: go east, and add 2 x + 3; else go south-east, and add 2 (x - y) + 5
//
// Without the 1/4, d would be a whole number and a quarter more, and never 0: no midpoint lies on
// the circle, and there are no ties. The other seven octants are mirror images.
//
//     draw_circle({{0, 0}, 2}, color, canvas, FlatPainter(image, color));
//     // (0,2)(2,0)(0,-2)(-2,0)  (1,2)(2,1)(2,-1)(1,-2)(-1,-2)(-2,-1)(-2,1)(-1,2)

#include <rastertrace/core/numbers/index.h>
#include <rastertrace/core/raster/canvas.h>
#include <rastertrace/core/raster/image.h>
#include <rastertrace/core/raster/line.h>
#include <rastertrace/core/raster/sink.h>
#include <rastertrace/core/raster/steps.h>

#include <algorithm>
#include <array>
#include <cstdint>

namespace rastertrace {

/// The largest radius of a circle, in pixels.
inline constexpr Index largest_radius = largest_canvas_side;

/// A circle around a point of the grid.
struct GridCircle {
    GridPoint center;
    Index radius = 0; ///< in pixels, from 0 to largest_radius; 0 is one pixel
};

/// Calls `visit` with the mirror images of a point at the axes and diagonals, clockwise where y
/// points up: eight, or four of a point that lies on one of these itself, or one of (0, 0).
template <typename Visit> void for_each_mirror_image(GridPoint p, Visit&& visit) {
    const std::array<GridPoint, 8> images{{{p.x, p.y},
                                           {p.y, p.x},
                                           {p.y, -p.x},
                                           {p.x, -p.y},
                                           {-p.x, -p.y},
                                           {-p.y, -p.x},
                                           {-p.y, p.x},
                                           {-p.x, p.y}}};
    for (const GridPoint* image = images.begin(); image != images.end(); ++image)
        if (std::find(images.begin(), image, *image) == image)
            visit(*image);
}

/// True if the square around the circle has a pixel of the canvas.
inline bool meets(const GridCircle& circle, const Canvas& canvas) {
    const auto& [center, radius] = circle;
    const Index row = canvas.row_of(center.y);
    return canvas.left() - radius <= center.x && center.x <= canvas.right() + radius &&
           -radius <= row && row < canvas.height + radius;
}

/// Draws a circle, each of its pixels once; false if it is nowhere near the canvas. The time is
/// proportional to the radius.
template <typename Sink>
requires SinkFor<Sink, LineDecided<>, PixelPlotted<>, PixelsRejected<>>
bool draw_circle(const GridCircle& circle, Color color, const Canvas& canvas, Sink&& sink) {
    if (!meets(circle, canvas))
        return false;
    const GridPoint& center = circle.center;
    const auto plot = [&](GridPoint p) {
        draw_point({center.x + p.x, center.y + p.y}, color, canvas, sink);
    };

    GridPoint at{0, circle.radius};
    std::int64_t d = 1 - circle.radius;
    for_each_mirror_image(at, plot);
    while (at.x < at.y) {
        // Is the midpoint of the next two pixels inside?
        const bool goes_east = d < 0;
        sink(LineDecided<>{.x = static_cast<int>(center.x + at.x),
                           .y = static_cast<int>(center.y + at.y),
                           .d = d,
                           .move = goes_east ? Move::e : Move::se});
        d += goes_east ? 2 * at.x + 3 : 2 * (at.x - at.y) + 5;
        at = {at.x + 1, goes_east ? at.y : at.y - 1};

        // Beyond the diagonal is a mirror image of the pixel before.
        if (at.x <= at.y)
            for_each_mirror_image(at, plot);
    }
    return true;
}

} // namespace rastertrace
