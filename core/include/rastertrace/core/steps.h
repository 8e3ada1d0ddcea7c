// SPDX-License-Identifier: MIT
#pragma once

// Every step that a rasterizer reports, in the order in which a picture meets them. A step is named
// after what just became known and carries the numbers that decided it.
//
//     draw<double>(scene, plan, [](const auto& step) { /* called for every step */ });
//
// Coordinates are the scene's own (canvas.h says which way y points); x, y and dx_dy are in pixels.

#include <rastertrace/core/canvas.h>
#include <rastertrace/core/image.h>
#include <rastertrace/core/vec.h>

#include <cstdint>
#include <span>
#include <string_view>

namespace rastertrace {

/// What kind of thing is drawn.
enum class PrimitiveKind { triangle };

/// A primitive begins. All steps up to the next PrimitiveBegan belong to it. The names and places
/// are those of the scene and live only as long as the call of the sink.
template <typename Scalar> struct PrimitiveBegan {
    PrimitiveKind kind;
    std::string_view name;
    std::span<const std::string_view> vertices; ///< their names, in the scene's order
    std::span<const Vec<Scalar, 2>> positions;  ///< of the vertices, in the same order
    Color color;                                ///< of every pixel that does not say otherwise
};

/// Two vertices of the current primitive, by their place in PrimitiveBegan::vertices.
struct EdgeName {
    std::uint8_t from = 0;
    std::uint8_t to = 0;

    friend bool operator==(const EdgeName&, const EdgeName&) = default;
};

/// An edge is set up: how far x moves when y grows by 1.
template <typename Scalar> struct EdgeSetUp {
    EdgeName edge;      ///< from its upper to its lower vertex, as seen in the picture
    bool is_horizontal; ///< then it has no dx_dy
    Scalar dx_dy;       ///< (x2 - x1)/(y2 - y1)
};

/// The two ends of a row are known.
template <typename Scalar> struct ScanlineSpanned {
    int y;
    Scalar left;  ///< x of the left edge on this row
    Scalar right; ///< x of the right edge on this row
    Index from;   ///< first pixel of the span: left, rounded
    Index to;     ///< last pixel of the span: right, rounded; empty when to < from
    EdgeName left_edge;
    EdgeName right_edge;
};

/// A pixel got a color.
struct PixelPlotted {
    Pixel pixel;
    Color color;
};

/// A run of pixels of one row, x from `from` to `to`, was dropped because the canvas has none of
/// them.
struct PixelsRejected {
    int y;
    Index from;
    Index to;
};

/// Whole rows, from the upper one to the lower one, were dropped because the canvas has none of
/// them.
struct RowsRejected {
    Index from_y;
    Index to_y;
};

/// Why a primitive draws nothing.
enum class SkipReason {
    off_canvas,   ///< it has pixels, and none of them lies on the canvas
    between_rows, ///< it lies between two rows of pixels
};

/// A primitive drew nothing; no further step belongs to it.
struct PrimitiveSkipped {
    SkipReason why;
};

} // namespace rastertrace
