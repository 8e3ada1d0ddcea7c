// SPDX-License-Identifier: MIT
// Bresenham's line from (0,0) to (5,2) by the algorithm itself, with a sink that prints its pixels.

#include <rastertrace/core/numbers/number.h>
#include <rastertrace/core/raster/flat_painter.h>
#include <rastertrace/core/raster/line_bresenham.h>

#include <cstdio>
#include <variant>

using namespace rastertrace;

struct PixelPrinter {
    void operator()(const PixelPlotted<>& step) const { std::printf("(%d,%d)", step.x, step.y); }
    void operator()(const auto& /*another step*/) const {}
};

int main() {
    const Canvas canvas{.width = 13, .height = 9};
    Image image(canvas);
    draw_bresenham({{0, 0}, {5, 2}, {}, {}}, LineRules(), canvas,
                   FlatPainter(image, Color{255, 0, 0}, PixelPrinter()));
    // What is compiled once is there, too.
    const auto slope = parse_number("2/5");
    std::printf(" m = %g\n", std::get<Number>(slope).nearest_double());
}
