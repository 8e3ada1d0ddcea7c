// SPDX-License-Identifier: MIT
#pragma once

// The fill of a text that has only lines: from each pixel of one edge draw a line to the third
// vertex. It leaves holes and draws pixels many times; three passes, one per edge, hide the holes
// but nothing proves that they always do. It is here to be seen.
//
// Source: the report on the full pipeline, DrawFilledTriangle: its line is Bresenham's, drawn from
// the end with the lower x (a vertical line from its first end).
//
//     fill_fan(triangle, colors, rules, canvas, FlatPainter(image, color));

#include <rastertrace/core/raster/canvas.h>
#include <rastertrace/core/raster/line_bresenham.h>
#include <rastertrace/core/raster/rounding.h>
#include <rastertrace/core/raster/triangle.h>

#include <array>
#include <cstdint>

namespace rastertrace {

/// The longest edge that a fan is drawn from, in pixels: it draws one line for each of them, on the
/// canvas or off it. No canvas is wider.
inline constexpr Index longest_fan_edge = largest_canvas_side;

/// The choices that the fan leaves open.
struct FanRules {
    int passes = 1;  ///< 1: from AB to C; 2: also from AC to B; 3: also from BC to A
    LineRules lines; ///< all end pixels are drawn, whatever they say
    const LineColors* colors = nullptr; ///< of all pixels, in the place of those of the vertices
};

/// Draws the triangle whose vertices are the pixels with the samples nearest to the given ones. `colors` are those
/// of the vertices; along a line they are mixed.
template <typename Scalar, typename Sink>
requires SinkFor<Sink, EdgeSetUp<>, RayBegan<>, LineDecided<>, PixelPlotted<>, PixelsRejected<>>
void fill_fan(const Triangle<Scalar>& triangle, const std::array<Color, 3>& colors,
              const SampleOffset<Scalar>& offset, const FanRules& rules, Canvas canvas,
              Sink&& sink) {
    const auto from_lower_x = [](const GridLine& line) {
        return line.to.x < line.from.x ? reversed(line) : line;
    };
    const auto vertex = [&](std::uint8_t index) {
        return nearest_pixel(triangle.vertices[index], offset);
    };

    LineRules line_rules = rules.lines;
    line_rules.ends = EndPixels::both;

    // The edge that the lines of each pass start from, and the vertex that they go to.
    struct Pass {
        std::uint8_t from, to, apex;
    };
    constexpr std::array<Pass, 3> passes{{{0, 1, 2}, {0, 2, 1}, {1, 2, 0}}};
    for (int i = 0; i < rules.passes; ++i) {
        const auto& [from, to, apex] = passes[static_cast<std::size_t>(i)];
        const GridPoint target = vertex(apex);
        const GridLine base =
            from_lower_x({vertex(from), vertex(to), colors[from], colors[to], rules.colors});
        sink(EdgeSetUp<>{.edge = {from, to}, .octant = octant_of(base.from, base.to)});

        // A line from each pixel of the edge.
        const BresenhamLine edge(base.from, base.to, line_rules.ties);
        for (Index step = 0; step <= edge.steps(); ++step) {
            const GridPoint start = edge.pixel(step);
            const Color color = color_on_line(base, line_rules, start, step, edge.steps());
            sink(RayBegan<>{.x = start.x, .y = start.y});
            draw_bresenham(from_lower_x({start, target, color, colors[apex], rules.colors}),
                           line_rules, canvas, sink);
        }
    }
}

} // namespace rastertrace
