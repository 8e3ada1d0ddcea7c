// SPDX-License-Identifier: MIT
#pragma once

// Which algorithm draws, on which numbers, with which conventions: what a scene's "method" says.
//
//     Method method{.scalar = ScalarKind::exact, .rounding = Rounding::truncate};

#include <rastertrace/core/draw/scene/algorithms.h>
#include <rastertrace/core/numbers/number.h>
#include <rastertrace/core/raster/choices.h>

#include <vector>

namespace rastertrace {

/// The numbers to draw with.
enum class ScalarKind {
    single_precision, ///< IEEE 754 binary32
    double_precision, ///< IEEE 754 binary64
    fixed,            ///< vertices snapped to 1/256 pixel, then exact whole numbers of that size
    adaptive,         ///< intervals of doubles, and fractions where these decide nothing: as exact
    exact,            ///< fractions of whole numbers; nothing is ever rounded but to a pixel
};

/// Where the colors of pixels come from.
enum class Shade {
    flat,        ///< the primitive's color
    faces,       ///< a color for each primitive, from a fixed list
    interpolate, ///< mixed from the colors of its vertices; in a perspective, as they mix in space
    affine,      ///< mixed as if the picture were flat: wrong in a perspective
    lambert,     ///< the primitive's color, as bright as its face is turned to the light
};

/// How triangles in front hide those behind.
enum class Depth {
    none,      ///< the last primitive drawn stays
    painter,   ///< sorted, the farthest drawn first
    linear_z,  ///< a buffer of the distance, interpolated on the screen: wrong in a perspective
    inverse_z, ///< a buffer of 1/distance, which is linear on the screen
    ndc_z,     ///< a buffer of z after the division by w, which is linear on the screen
};

/// When a pixel passes the depth test. Always strict: of equal depths, the first stays.
enum class DepthCompare {
    automatic, ///< what is nearer passes
    less,
    greater,
};

/// Where the depths of a row's ends lie.
enum class DepthAt {
    pixel,        ///< where the edges meet the row: each pixel has the depth at its sample point
    rounded_ends, ///< at the row's first and last pixel; a single pixel has that of its left end
};

/// Where screen vertices go before anything is drawn.
enum class Snap {
    none,
    floor,
    truncate, ///< toward zero
    nearest,  ///< a half goes as `ties` says, up if it says nothing
};

/// Which horizontal edge of a triangle has the samples on it, beside the left edges.
enum class HorizontalEdge {
    top,    ///< as Direct3D has it
    bottom, ///< as Mesa's OpenGL has it
};

/// A named set of choices, of graphics hardware, another rasterizer or a course
/// (trace/text/conventions.h). What it sets stands in the other members; it decides nothing itself.
enum class Convention {
    none,
    opengl,
    direct3d,
    vulkan,
    cgfs,
    tinyrenderer,
    cs418,
    scotty3d,
};

struct Mistake; // model/mistakes.h

/// The choices of a scene and their defaults: `nullopt` where that depends on what is drawn.
struct Method {
    Convention convention = Convention::none;
    ScalarKind scalar = ScalarKind::double_precision;
    LineMethod line = LineMethod::bresenham;
    LineStart from = LineStart::first;
    EndPixels ends = EndPixels::both;
    Fill fill = Fill::scanline;
    HorizontalEdge horizontal_edge = HorizontalEdge::top; ///< of top-left
    FillRule fill_rule = FillRule::even_odd;              ///< of polygons
    PolygonVertices polygon_vertices = PolygonVertices::half_open;
    int fan_passes = 1;
    std::optional<Rounding> rounding = {}; ///< floor for spans, nearest for lines
    std::optional<Ties> ties = {};         ///< up, of Bresenham's lines start
    std::optional<Sample> sample = {};     ///< center for top-left, else integer
    std::optional<RowRule> rows = {};      ///< closed for triangles by rows, half-open for polygons
    LerpForm lerp = LerpForm::direct;
    Snap snap = Snap::none;
    Cull cull = Cull::none;
    std::optional<Depth> depth = {}; ///< inverse-z in a perspective, linear-z under orthographic
    DepthCompare depth_compare = DepthCompare::automatic;
    DepthAt depth_at = DepthAt::pixel; ///< of fills that find depths along the edges
    PainterKey painter_key = PainterKey::mean;
    std::optional<Shade> shade = {};          ///< interpolate if a vertex has a color, else flat
    std::optional<ColorLerp> color_lerp = {}; ///< space in a perspective, else axis
    ColorRounding color_rounding = ColorRounding::nearest;
    std::vector<const Mistake*> mistakes = {}; ///< that the scene is drawn with, to show them
};

/// True if every decision is the one that exact arithmetic takes.
inline bool decides_exactly(const Method& method) {
    return method.scalar == ScalarKind::exact || method.scalar == ScalarKind::adaptive;
}

/// How the ends of a fill's spans become pixels.
inline SpanRounding span_rounding(const Method& method) {
    return {method.rounding.value_or(Rounding::floor), method.ties.value_or(Ties::up)};
}

/// Which rows triangles have that are filled by them.
inline RowRule rows_of_triangles(const Method& method) {
    return method.rows.value_or(RowRule::closed);
}

/// Where lines go halfway between two pixels: those that round up, as textbooks' floor(v + 1/2).
inline Ties ties_of_lines(const Method& method) {
    const bool rounds = traits_of(method.line).rule == LineRule::rounding;
    return method.ties.value_or(rounds ? Ties::up : Ties::start);
}

/// How the coordinates across naive and dda lines become pixels.
inline SpanRounding line_rounding(const Method& method) {
    return {method.rounding.value_or(Rounding::nearest), ties_of_lines(method)};
}

/// What lines and their colors go by; those in space have their own (GridLine::colors).
inline LineRules line_rules(const Method& method) {
    return {method.color_lerp.value_or(ColorLerp::axis), method.color_rounding,
            ties_of_lines(method), method.ends};
}

/// The samples that triangles are filled by.
inline Sample sample_of(const Method& method) {
    return method.sample.value_or(traits_of(method.fill).sample);
}

/// Those of primitives that are SampledBy::itself, which only a scene's own word moves.
inline Sample sample_of_others(const Method& method) {
    return method.sample.value_or(Sample::integer);
}

/// Those of lines, and of the sides of outlines.
inline Sample sample_of_lines(const Method& method) {
    return traits_of(method.line).rule == LineRule::diamonds ? sample_of(method)
                                                             : sample_of_others(method);
}

/// From a pixel's integer point to its sample, in x and in y.
inline Number offset_of(Sample sample) {
    return sample == Sample::center ? Number::decimal(5, -1) : Number(0);
}

/// The canvas as `top-left` fills it: the top edge of a turned one is the bottom edge in the picture.
inline Canvas canvas_of_samples(const Method& method, const Canvas& canvas) {
    return method.horizontal_edge == HorizontalEdge::bottom ? canvas.turned() : canvas;
}

} // namespace rastertrace
