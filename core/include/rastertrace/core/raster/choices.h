// SPDX-License-Identifier: MIT
#pragma once

// What the algorithms leave open, as enumerations and plain structs. Code that names a choice, such as a method, includes
// this header and no algorithm.

namespace rastertrace {

/// How the ends of a span become pixels; see the table of rounding.h.
enum class Rounding { floor, nearest, truncate, inside, half_open };

/// Where `nearest` sends a number halfway between two whole numbers.
enum class Ties {
    start, ///< to the smaller one: -1/2 -> -1, 1/2 -> 0. Lines stay on the side that they come
           ///< from, as Bresenham's does (pixel_across)
    up,    ///< to the larger one: -1/2 -> 0, 1/2 -> 1
    away,  ///< away from zero: -1/2 -> -1, 1/2 -> 1
    even,  ///< to the even one: -1/2 -> 0, 1/2 -> 0
    step,  ///< of lines only: to the side that they go to, the other one than with `start`
};

/// What becomes of a color's channel that was mixed or lit and is no whole level.
enum class ColorRounding {
    nearest,  ///< the nearest level; a half goes up
    truncate, ///< the level below, as a C++ cast has it
};

/// The rules that turn the ends of a span into pixels.
struct SpanRounding {
    Rounding rounding = Rounding::floor;
    Ties ties = Ties::up; ///< read only with Rounding::nearest
};

/// How the values of a linear interpolation are found, row after row.
enum class LerpForm {
    direct,      ///< d = d1 + a (i - i1) on every row
    incremental, ///< d = d1 + a (i - i1) on the first row that is drawn, then d += a
};

/// Which rows a triangle has, or a polygon (fill_edge_table.h).
enum class RowRule {
    closed,    ///< from that of its highest vertex to that of its lowest, both included
    half_open, ///< of a triangle, the lowest left out: a row that two share belongs to the lower one
};

/// Which edges of a polygon have the row of their vertex at the larger y.
enum class PolygonVertices {
    half_open, ///< none (Foley and van Dam)
    turning, ///< those of a vertex where the outline turns back, which counts twice; where it goes
             ///< on it counts once. Neighbors that are level with it do not count (Hearn and Baker)
};

/// Which points lie inside a polygon that crosses itself, by its winding number there: how often it
/// runs around the point.
enum class FillRule {
    even_odd, ///< those around which it is odd
    non_zero, ///< those around which it is not 0
};

/// The end at which a line starts to be drawn.
enum class LineStart {
    first, ///< the one that the scene names first
    low,   ///< the one with the lower coordinate along the major axis
};

/// What the color along a line goes by.
enum class ColorLerp {
    space,    ///< the place on the line in space: in a perspective, each share is divided by w
    axis,     ///< the step along the major axis
    distance, ///< the distance from the end, over the length of the line
};

/// Which of its end pixels a line draws.
enum class EndPixels {
    both,
    first, ///< the one that it starts from: lines that follow one another draw no pixel twice
};

/// The choices that lines leave open.
struct LineRules {
    ColorLerp color_lerp = ColorLerp::axis;
    ColorRounding color_rounding = ColorRounding::nearest;
    Ties ties = Ties::
        start; ///< halfway between two pixels; of Bresenham's line, at d = 0, `step` goes diagonally, all
               ///< others straight on
    EndPixels ends = EndPixels::both;
};

/// Which faces are not drawn. A face is seen from its front if its normal points to the eye:
/// normal . view > 0. Seen from the edge (0) it is not drawn whenever anything is culled.
enum class Cull {
    none,
    back,
    front,
    both,
    light, ///< faces turned from the light: wrong, and shown as such
};

/// Which distance of a face the painter sorts by.
enum class PainterKey { nearest, farthest, mean };

} // namespace rastertrace
