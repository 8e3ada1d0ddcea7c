// SPDX-License-Identifier: MIT
#pragma once

// The primitives and the algorithms that a scene can name, and their properties: a row for each. A new algorithm is a
// page in raster/, an enumerator, its row here, and its case in draw/paint/fill.h, or for a line in
// draw_line of draw_in.h.
//
//     traits_of(Fill::top_left).depths;  // DepthForm::plane

#include <rastertrace/core/raster/steps.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <string_view>

namespace rastertrace {

/// The kinds of primitives, in the order in which a scene's lists of them are drawn: what is thin
/// comes last and stays visible.
inline constexpr std::array all_primitives{PrimitiveKind::triangle, PrimitiveKind::polygon,
                                           PrimitiveKind::outline,  PrimitiveKind::line,
                                           PrimitiveKind::circle,   PrimitiveKind::point};

/// Of two equal depths, that of the thinner primitive passes.
enum class Thickness : std::uint8_t { point, line, face };

/// Whose samples a primitive is drawn by, where the scene does not say where they lie.
enum class SampledBy : std::uint8_t {
    fill,
    line,
    itself, ///< at integer points, whatever fills and lines have
};

struct PrimitiveTraits {
    std::string_view name; ///< in a trace
    std::string_view list; ///< of a scene
    std::size_t corners;   ///< how many vertices it has; with rings, so many or more
    Thickness thickness;   ///< a face is filled: it is tested, lit and sorted
    SampledBy samples;
    bool has_depth = true;   ///< false: it is drawn in the picture, beside no depth buffer
    bool has_radius = false; ///< around its vertex
    bool has_ring = false;   ///< of any number of vertices
};

/// The algorithm that fills triangles.
enum class Fill {
    scanline,    ///< row by row, the long edge against the two short ones joined
    two_halves,  ///< the lower half, then the upper one
    barycentric, ///< every pixel of the box, by its barycentric coordinates
    top_left,    ///< edge functions; each sample of a shared edge has one owner
    fan,         ///< a line from each pixel of an edge to the third vertex; has holes
};
inline constexpr std::array all_fills{Fill::scanline, Fill::two_halves, Fill::barycentric,
                                      Fill::top_left, Fill::fan};

/// The algorithm that draws lines, and the sides of outlines.
enum class LineMethod { naive, dda, bresenham, diamond_exit };
inline constexpr std::array all_lines{LineMethod::naive, LineMethod::dda, LineMethod::bresenham,
                                      LineMethod::diamond_exit};

/// What decides which pixels a fill draws.
enum class PixelRule {
    row_ends, ///< the two ends of each row, rounded
    samples,  ///< whether the pixel's sample lies in the triangle
    lines,    ///< Bresenham's lines between pixels
};

/// Where a pixel has its sample, the point at which fills and lines look.
enum class Sample {
    integer, ///< its integer point
    center,  ///< half a pixel from there, in x and in y
};

/// How a fill finds the depths of its pixels (depth_interpolation.h).
enum class DepthForm {
    none,        ///< it cannot: it may not be asked for them
    along_edges, ///< along the edges, then across each row
    plane,       ///< as a plane over the screen
    weights,     ///< by the weights of each sample: in exact arithmetic, that plane
};

struct FillTraits {
    std::string_view name; ///< in a scene
    PixelRule rule;
    DepthForm depths;
    Sample sample = Sample::integer; ///< unless the scene says otherwise
    bool is_closed = false;          ///< by samples: those on any edge are drawn
    bool tests_box = false; ///< every pixel of the box, where others ask only for what they draw
};

/// How many bits a fraction's numerator may have, with coordinates n/D, |n| < 2^b and D <= 2^d.
struct BitsNeeded {
    int per_numerator_bit = 0;
    int per_denominator_bit = 0;
    int more = 0;

    constexpr int of(int b, int d) const {
        return per_numerator_bit * b + per_denominator_bit * d + more;
    }
};

/// What decides which pixels a line draws.
enum class LineRule {
    grid,     ///< whole numbers: it goes from pixel to pixel
    rounding, ///< the other coordinate at each step, rounded as the method says
    diamonds, ///< those around the samples that it leaves
};

struct LineTraits {
    std::string_view name; ///< in a scene
    LineRule rule;
    bool adds_up = false;     ///< each step adds to the one before
    BitsNeeded fraction = {}; ///< more than an edge needs (plan.cpp)
};

/// Ends a switch that has a case for every enumerator: the compiler warns of a new one.
[[noreturn]] inline void not_an_enumerator() {
    std::abort();
}

constexpr PrimitiveTraits traits_of(PrimitiveKind kind) {
    switch (kind) {
    case PrimitiveKind::triangle:
        return {"triangle", "triangles", 3, Thickness::face, SampledBy::fill};
    case PrimitiveKind::polygon:
        return {.name = "polygon",
                .list = "polygons",
                .corners = 3,
                .thickness = Thickness::face,
                .samples = SampledBy::itself,
                .has_depth = false,
                .has_ring = true};
    case PrimitiveKind::outline:
        return {"outline", "outlines", 3, Thickness::line, SampledBy::line};
    case PrimitiveKind::line:
        return {"line", "lines", 2, Thickness::line, SampledBy::line};
    case PrimitiveKind::circle:
        return {.name = "circle",
                .list = "circles",
                .corners = 1,
                .thickness = Thickness::line,
                .samples = SampledBy::itself,
                .has_depth = false,
                .has_radius = true};
    case PrimitiveKind::point:
        return {"point", "points", 1, Thickness::point, SampledBy::itself};
    }
    not_an_enumerator();
}

/// True if its inside is drawn.
constexpr bool is_filled(PrimitiveKind kind) {
    return traits_of(kind).thickness == Thickness::face;
}

constexpr FillTraits traits_of(Fill fill) {
    switch (fill) {
    case Fill::scanline:
        return {.name = "scanline", .rule = PixelRule::row_ends, .depths = DepthForm::along_edges};
    case Fill::two_halves:
        return {
            .name = "two-halves", .rule = PixelRule::row_ends, .depths = DepthForm::along_edges};
    case Fill::barycentric:
        return {.name = "barycentric",
                .rule = PixelRule::samples,
                .depths = DepthForm::weights,
                .is_closed = true,
                .tests_box = true};
    case Fill::top_left:
        return {.name = "top-left",
                .rule = PixelRule::samples,
                .depths = DepthForm::plane,
                .sample = Sample::center};
    case Fill::fan:
        return {.name = "fan", .rule = PixelRule::lines, .depths = DepthForm::none};
    }
    not_an_enumerator();
}

constexpr LineTraits traits_of(LineMethod line) {
    switch (line) {
    case LineMethod::naive: // y = m x + b has the denominator of m twice
        return {.name = "naive", .rule = LineRule::rounding, .fraction = {3, 2, 8}};
    case LineMethod::dda:
        return {.name = "dda", .rule = LineRule::rounding, .adds_up = true};
    case LineMethod::bresenham:
        return {.name = "bresenham", .rule = LineRule::grid};
    case LineMethod::diamond_exit:
        return {.name = "diamond-exit", .rule = LineRule::diamonds, .fraction = {3, 2, 8}};
    }
    not_an_enumerator();
}

} // namespace rastertrace
