// SPDX-License-Identifier: MIT
#pragma once

// Every step that a rasterizer reports, in the order in which a picture meets them. A step is named
// after what just became known and carries the numbers that decided it.
//
//     draw(scene, plan, [](const auto& step) { /* called for every step */ });
//
// Coordinates on the screen are the scene's own (canvas.h says which way y points); x, y and dx_dy
// are in pixels.

#include <rastertrace/core/numbers/scalar.h>
#include <rastertrace/core/numbers/vec.h>
#include <rastertrace/core/raster/canvas.h>
#include <rastertrace/core/raster/image.h>
#include <rastertrace/core/transform/matrix.h>

#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <string_view>

namespace rastertrace {

/// What kind of thing is drawn.
enum class PrimitiveKind { triangle, polygon, outline, line, point, circle };

/// A face that is not convex has been cut into triangles: it was seen along an axis, and its ears
/// were cut (triangulate.h). Whatever the Scalar of a scene, this is decided in exact numbers.
template <typename Scalar> struct FaceTriangulated {
    std::string_view name;
    std::span<const std::string_view> vertices; ///< of the face, in the author's order
    std::span<const Vec<Scalar, 3>> at;         ///< where they are, in object space
    Vec<Scalar, 3> normal;                      ///< Newell's: its length is twice the area
    char dropped;                               ///< x, y or z: of its largest component
    std::span<const std::string_view> ears;     ///< the primitives that it is drawn as
};

/// A transform from one space to the next is known. Points are columns on its right.
template <typename Scalar> struct MatrixSetUp {
    std::string_view name;   ///< model, view, projection or viewport
    std::string_view object; ///< the mesh that a model belongs to; "" for the scene's own vertices
    const Matrix<Scalar>& matrix;
    /// What `matrix` is the product of, the last of which moves a point first, each rounded by
    /// itself. None if an entry is too large for a Scalar.
    std::span<const MatrixFactor<Scalar>> factors;
    /// Of a view: the camera's position, what it looks at, and what is up for it.
    std::span<const Vec<Scalar, 3>> camera;
};

/// The spaces that a vertex passes on its way to the screen.
enum class Space { object, world, camera, clip, canonical, screen };

/// The place of a vertex in one of its spaces is known.
template <typename Scalar> struct VertexPlaced {
    std::string_view name;
    Space space;
    std::span<const Scalar> at; ///< x, y, z; in clip space also w; on the screen x, y in pixels
    std::span<const Scalar> snapped; ///< on the screen: where `snap` moves it; else empty
};

/// The painter has sorted the faces: this is the order in which they are drawn.
template <typename Scalar> struct PrimitivesOrdered {
    std::span<const std::string_view> names;
    std::span<const Scalar> distances;    ///< from the eye: the key that each was sorted by
    std::span<const std::size_t> indices; ///< in Scene::primitives
};

/// A face was asked whether it is turned to the eye, or to the light.
template <typename Scalar> struct FaceTested {
    Vec<Scalar, 3> normal;        ///< (P2 - P1) x (P3 - P1) in the world, its length twice the area
    Vec<Scalar, 3> view;          ///< from the face's centroid to the eye, or to the light
    Scalar dot;                   ///< normal . view: the front is seen if it is above 0
    std::optional<double> cosine; ///< of the angle between them; none if one has no length
    bool is_by_light;             ///< `view` leads to the light
    bool is_culled;
    bool is_culled_opposite; ///< the verdict, had `view` been taken from the eye to the face
};

/// The light on a face is known.
template <typename Scalar> struct FaceLit {
    Vec<Scalar, 3> normal;
    Vec<Scalar, 3> light; ///< toward the light, from the face's centroid
    Scalar dot;           ///< normal . light
    double intensity;     ///< the cosine of the angle between them, 0 if it is negative
    Color color;          ///< of the face in this light
};

/// A primitive with a vertex outside a plane of the space that can be seen met that plane.
struct PrimitiveClipped {
    std::string_view name;           ///< of the primitive; the sides of an outline come one by one
    std::string_view plane;          ///< near, far, left, right, bottom or top
    std::span<const bool> is_inside; ///< of its vertices so far, those on the plane included
    int left;                        ///< how many vertices it has now
};

/// A primitive begins. All steps up to the next PrimitiveBegan belong to it. The names and places
/// are those of the scene and live only as long as the call of the sink. A primitive that clipping
/// cuts begins without places; what is left of it is drawn in one or more parts, each of which
/// begins as a primitive of its own.
template <typename Scalar> struct PrimitiveBegan {
    PrimitiveKind kind;
    std::string_view name;
    std::span<const std::string_view> vertices; ///< their names, in the scene's order
    std::span<const Vec<Scalar, 2>> positions;  ///< of the vertices on the screen, or none
    Color color;                                ///< of every pixel that does not say otherwise
    std::span<const Color> colors;              ///< of the vertices, if they are mixed; else empty
    int octant = 0;                             ///< of a line, see octant_of; else 0
    bool is_part = false;                       ///< of the primitive that began before it
    std::span<const DepthOf<Scalar>> depths = {}; ///< of the vertices, if there is a depth buffer
    bool is_painted = true; ///< false: a triangle that hides what lies behind it, and is not seen
    Index radius = 0;       ///< of a circle, in pixels; else 0
    std::string_view face =
        {}; ///< of more than three corners, that the triangle is a part of; "" if there is none
    /// In the place of `colors`, red, green, blue and alpha of each vertex, if clipping has cut an
    /// edge between two colors; else empty.
    std::span<const std::array<DepthOf<Scalar>, 4>> levels = {};
};

/// Two vertices of the current primitive, by their place in PrimitiveBegan::vertices.
struct EdgeName {
    std::uint16_t from = 0;
    std::uint16_t to = 0;

    friend bool operator==(const EdgeName&, const EdgeName&) = default;
};

/// An edge is set up: how far x moves when y grows by 1.
template <typename Scalar> struct EdgeSetUp {
    EdgeName edge;      ///< from its upper to its lower vertex, as seen in the picture
    bool is_horizontal; ///< then it has no dx_dy
    Scalar dx_dy;       ///< (x2 - x1)/(y2 - y1)
};

/// An edge is set up as a function that is 0 on the edge, positive on the triangle's side of it and
/// negative on the other: a (x - x1) + b (y - y1), in square pixels (edge_function.h).
template <typename Scalar> struct EdgeFunctionSetUp {
    EdgeName edge; ///< from its upper vertex (x1, y1) to its lower one, as seen in the picture
    Scalar a;
    Scalar b;
    bool is_top_left; ///< a sample on the edge belongs to the triangle
};

/// A side of the current primitive is about to be drawn as a line.
struct SideBegan {
    EdgeName edge;
    int octant; ///< see octant_of
};

/// One of the two halves of a triangle is about to be filled.
struct HalfBegan {
    bool is_upper;
    Index from_y; ///< its first row, and
    Index to_y;   ///< its last; it has no row if they are in the wrong order
};

/// A line of the fan begins at this pixel.
struct RayBegan {
    Index x;
    Index y;
};

/// The edges of a polygon that a row meets are known, from left to right. The polygon's inside lies
/// between two of them where the winding number says so.
template <typename Scalar> struct RowCrossed {
    int y;
    std::span<const EdgeName> edges; ///< each from its upper to its lower vertex
    std::span<const Scalar> x;       ///< of each on this row
    std::span<const int> winding;    ///< right of each: how often the polygon runs around
};

/// The two ends of a row are known, or of one of the spans that a polygon has in a row.
template <typename Scalar> struct ScanlineSpanned {
    int y;
    Scalar left;  ///< x of the left edge on this row
    Scalar right; ///< x of the right edge on this row
    Index from;   ///< first pixel of the span: left, rounded
    Index to;     ///< last pixel of the span: right, rounded; empty when to < from
    EdgeName left_edge;
    EdgeName right_edge;
    std::optional<DepthOf<Scalar>> left_depth = {}; ///< where depths are interpolated by rows
    std::optional<DepthOf<Scalar>> right_depth = {};
};

/// A line's minor coordinate is known at a step along its major one.
template <typename Scalar> struct LineSampled {
    bool is_x_major; ///< the line goes from column to column, else from row to row
    Index at;        ///< x if it is x-major, else y
    Scalar value;    ///< the other coordinate on the line
    Index pixel;     ///< the same, rounded
};

/// Where a line goes next: E is x + 1, N is y + 1, whichever way y points on the canvas.
enum class Move { e, ne, n, nw, w, sw, s, se };

/// Bresenham's line has decided where to go from a pixel, or a circle from one of its octant that
/// begins at the largest y; that one may lie off the canvas.
struct LineDecided {
    Pixel pixel;
    std::int64_t d; ///< straight on if d <= 0, of a circle if d < 0; else diagonally
    Move move;
};

/// A sample point met a triangle.
template <typename Scalar> struct SampleTested {
    Pixel pixel;
    std::array<Scalar, 3> weights; ///< of the vertices, in the scene's order; they sum to 1
    bool is_inside;                ///< none is negative
};

/// What a depth test was decided by.
enum class DepthReason : std::uint8_t {
    stored,  ///< the depth that is stored: what is nearer passes, or as near and thinner
    side_of, ///< it passes what is nearer in the pixel, being a side or a corner of that
    beside,  ///< it passes a face that is nearer in the pixel, but does not cover the line's own
             ///< point, or is not nearer there
    behind, ///< a face in the pixel, or next to it, covers the line's own point and is nearer there
};

/// A pixel met the depth buffer. Of equal depths the first one stays, but what is thinner passes: a
/// line before a face, a point before both. Points and lines are kept apart from faces
/// (line_painter.h).
template <typename Scalar> struct DepthTested {
    Pixel pixel;
    Scalar depth; ///< of the primitive at this pixel
    std::optional<Scalar>
        stored; ///< of the nearest face, point or line; of the nearest point or line if
                ///< that decides; none if nothing was drawn, and no number is farther
    bool passes;
    DepthReason reason = DepthReason::stored;
    std::string_view other = {}; ///< the primitive that `reason` is about
};

/// A pixel got a color.
struct PixelPlotted {
    Pixel pixel;
    Color color;
};

/// Pixels in a row, or one behind the other on a line, were dropped because the canvas has none of
/// them: from the first to the last.
struct PixelsRejected {
    Index from_x;
    Index from_y;
    Index to_x;
    Index to_y;
};

/// Whole rows, from the upper one to the lower one, were dropped because the canvas has none of
/// them.
struct RowsRejected {
    Index from_y;
    Index to_y;
};

/// Intervals of doubles leave a decision about a primitive open, so all of it is drawn in fractions.
/// Fires before its first step.
struct BoundExceeded {
    std::string_view name; ///< of the primitive, or of the part of one
    double difference;     ///< of the two, as it was calculated
    double error;          ///< that it may be off by
};

/// Why a primitive draws nothing.
enum class SkipReason {
    off_canvas,        ///< it has pixels, and none of them lies on the canvas
    between_rows,      ///< it lies between two rows of pixels
    zero_area,         ///< its area is 0, and the fill has no use for that
    culled,            ///< its face is turned away
    behind_eye,        ///< clipping left nothing: all of it lies behind the eye, or beside it
    too_near,          ///< clipping left nothing: all of it lies nearer than the near plane
    too_far,           ///< clipping left nothing: all of it lies beyond the far plane
    outside_view,      ///< clipping left nothing: all of it lies far outside the canvas
    last_pixel_only,   ///< a line of one pixel, whose last pixel is left out
    leaves_no_diamond, ///< a line that ends in the diamond that it begins in, or between diamonds
};

/// A primitive drew nothing; no further step belongs to it.
struct PrimitiveSkipped {
    SkipReason why;
};

} // namespace rastertrace
