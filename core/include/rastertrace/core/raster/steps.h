// SPDX-License-Identifier: MIT
#pragma once

// Every step that a rasterizer reports, in the order in which a picture meets them. A step is named
// after what just became known and carries the numbers that decided it. While a scene is drawn,
// Number is its scalar, for a listener Quantity, in a trace TracedNumber; beside its fields, a step
// has the table of them that traces are written and read by.
//
//     draw(scene, plan, [](const auto& step) { /* called for every step */ });
//
// Coordinates on the screen are the scene's own (canvas.h says which way y points); x, y and dx_dy
// are in pixels.

#include <rastertrace/core/raster/step_fields.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string_view>
#include <variant>

namespace rastertrace {

class Quantity;

/// The kinds of step; the end record of a trace counts them in this order.
enum class StepKind : std::uint8_t {
    triangulate,
    matrix,
    vertex,
    order,
    primitive,
    face,
    light,
    clip,
    edge,
    half,
    ray,
    crossings,
    scanline,
    along,
    decide,
    sample,
    depth,
    pixel,
    reject,
    skip,
    undecided,
};

/// The value of "step" of each, in a trace.
inline constexpr std::array<std::string_view, 21> step_names{
    "triangulate", "matrix", "vertex", "order", "primitive", "face",     "light",
    "clip",        "edge",   "half",   "ray",   "crossings", "scanline", "along",
    "decide",      "sample", "depth",  "pixel", "reject",    "skip",     "undecided"};

/// What kind of thing is drawn.
enum class PrimitiveKind { triangle, polygon, outline, line, point, circle };

/// A face that is not convex has been cut into triangles: it was seen along an axis, and its ears
/// were cut (triangulate.h). Whatever the Scalar of a scene, this is decided in exact numbers.
template <typename Number = Quantity> struct FaceTriangulated {
    static constexpr StepKind step_kind = StepKind::triangulate;

    held::Name<Number> name = {};
    held::List<Number, held::Name<Number>> vertices = {}; ///< of the face, in the author's order
    held::List<Number, held::Vector<Number, 3>> at = {};  ///< where they are, in object space
    held::Vector<Number, 3> normal = {};              ///< Newell's: its length is twice the area
    held::Name<Number> drops = {};                    ///< x, y or z: of its largest component
    held::List<Number, held::Name<Number>> ears = {}; ///< the primitives that it is drawn as

    using Fields = FieldTable<field::Key<"name", &FaceTriangulated::name, field::required>,
                              field::Told<"vertices", &FaceTriangulated::vertices>,
                              field::Reason<"at", &FaceTriangulated::at>,
                              field::Reason<"normal", &FaceTriangulated::normal>,
                              field::Decision<"drops", &FaceTriangulated::drops>,
                              field::Decision<"ears", &FaceTriangulated::ears>>;
};

/// A transform from one space to the next is known. Points are columns on its right.
template <typename Number = Quantity> struct MatrixSetUp {
    static constexpr StepKind step_kind = StepKind::matrix;
    using Row = held::Array<Number, Number, 4>;

    held::Name<Number> name = {};                        ///< model, view, projection or viewport
    held::Maybe<Number, held::Name<Number>> object = {}; ///< the mesh that a model belongs to
    held::List<Number, Row> rows = {};
    /// What the matrix is the product of, the last of which moves a point first, each rounded by
    /// itself. None if an entry is too large for a Number.
    held::Maybe<Number, held::List<Number, held::Name<Number>>> factors = {};
    held::Maybe<Number, held::List<Number, Row>> factor_rows = {}; ///< four of each
    /// Of a view: the camera's position, what it looks at, and what is up for it.
    held::Maybe<Number, held::List<Number, held::Vector<Number, 3>>> camera = {};

    using Fields = FieldTable<field::Key<"name", &MatrixSetUp::name, field::required>,
                              field::Key<"object", &MatrixSetUp::object>,
                              field::Told<"rows", &MatrixSetUp::rows>,
                              field::Told<"factors", &MatrixSetUp::factors>,
                              field::Told<"factor_rows", &MatrixSetUp::factor_rows>,
                              field::Told<"camera", &MatrixSetUp::camera>>;
};

/// The spaces that a vertex passes on its way to the screen.
enum class Space { object, world, camera, clip, canonical, screen };

/// The place of a vertex in one of its spaces is known.
template <typename Number = Quantity> struct VertexPlaced {
    static constexpr StepKind step_kind = StepKind::vertex;

    held::Name<Number> name = {};
    held::Word<Number, Space> space = {};
    held::List<Number, Number> at =
        {}; ///< x, y, z; in clip space also w; on the screen x, y in pixels
    held::Maybe<Number, held::List<Number, Number>> snapped =
        {}; ///< on the screen: where `snap` moves it

    using Fields = FieldTable<field::Key<"name", &VertexPlaced::name, field::required>,
                              field::Key<"space", &VertexPlaced::space, field::required>,
                              field::Reason<"at", &VertexPlaced::at>,
                              field::Decision<"snapped", &VertexPlaced::snapped>>;
};

/// The painter has sorted the faces: this is the order in which they are drawn.
template <typename Number = Quantity> struct PrimitivesOrdered {
    static constexpr StepKind step_kind = StepKind::order;

    held::List<Number, held::Name<Number>> names = {};
    held::List<Number, Number> distances = {}; ///< from the eye: the key that each was sorted by
    held::List<Number, held::Whole<Number>> listed = {}; ///< their places in the scene, from 1

    using Fields = FieldTable<field::Decision<"names", &PrimitivesOrdered::names>,
                              field::Reason<"distances", &PrimitivesOrdered::distances>,
                              field::Told<"listed", &PrimitivesOrdered::listed>>;
};

/// A primitive begins. All steps up to the next PrimitiveBegan belong to it. The names and places
/// are those of the scene and live only as long as the call of the sink. A primitive that clipping
/// cuts begins without places; what is left of it is drawn in one or more parts, each of which
/// begins as a primitive of its own.
template <typename Number = Quantity> struct PrimitiveBegan {
    static constexpr StepKind step_kind = StepKind::primitive;
    using Depth = DepthOf<Number>;

    held::Word<Number, PrimitiveKind> kind = {};
    held::Name<Number> name = {};
    held::List<Number, held::Name<Number>> vertices = {}; ///< their names, in the scene's order
    held::Maybe<Number, held::List<Number, held::Vector<Number, 2>>> at =
        {}; ///< of the vertices on the screen
    held::Maybe<Number, held::List<Number, Depth>> depths =
        {};                         ///< of the vertices, if there is a depth buffer
    held::Color<Number> color = {}; ///< of every pixel that does not say otherwise
    held::Maybe<Number, held::List<Number, held::Color<Number>>> colors =
        {}; ///< of the vertices, if they are mixed
    /// In the place of `colors`, red, green, blue and alpha of each vertex, if clipping has cut an
    /// edge between two colors.
    held::Maybe<Number, held::List<Number, held::Array<Number, Depth, 4>>> levels = {};
    held::Maybe<Number, Index> octant = {}; ///< of a line, see octant_of
    held::Maybe<Number, held::Flag<Number>> part =
        {}; ///< true: of the primitive that began before it
    held::Maybe<Number, held::Flag<Number>> painted =
        {}; ///< false: it hides what lies behind it, and is not seen
    held::Maybe<Number, Index> radius = {}; ///< of a circle, in pixels
    held::Maybe<Number, held::Name<Number>> face =
        {}; ///< of more than three corners, that the triangle is a part of

    using Fields = FieldTable<field::Told<"kind", &PrimitiveBegan::kind, field::required>,
                              field::Key<"name", &PrimitiveBegan::name, field::required>,
                              field::Told<"vertices", &PrimitiveBegan::vertices>,
                              field::Reason<"at", &PrimitiveBegan::at>,
                              field::Reason<"depths", &PrimitiveBegan::depths>,
                              field::Told<"color", &PrimitiveBegan::color>,
                              field::Reason<"colors", &PrimitiveBegan::colors>,
                              field::Reason<"levels", &PrimitiveBegan::levels>,
                              field::Decision<"octant", &PrimitiveBegan::octant>,
                              field::Told<"part", &PrimitiveBegan::part>,
                              field::Told<"painted", &PrimitiveBegan::painted>,
                              field::Reason<"radius", &PrimitiveBegan::radius>,
                              field::Told<"face", &PrimitiveBegan::face>>;
};

/// A face was asked whether it is turned to the eye, or to the light.
template <typename Number = Quantity> struct FaceTested {
    static constexpr StepKind step_kind = StepKind::face;

    held::NameOfPrimitive<Number> name = {};
    held::Vector<Number, 3> normal =
        {}; ///< (P2 - P1) x (P3 - P1) in the world, its length twice the area
    held::Vector<Number, 3> view = {}; ///< from the face's centroid to the eye, or to the light
    Number dot = {};                   ///< normal . view: the front is seen if it is above 0
    held::OrNull<Number, held::Cosine<Number>> cosine =
        {}; ///< of the angle between them; none if one has no length
    held::Maybe<Number, held::Name<Number>> by = {}; ///< light: `view` leads to it
    held::Flag<Number> culled = {};
    held::Flag<Number> opposite =
        {}; ///< the verdict, had `view` been taken from the eye to the face

    using Fields = FieldTable<
        field::Key<"name", &FaceTested::name>, field::Reason<"normal", &FaceTested::normal>,
        field::Reason<"view", &FaceTested::view>,
        field::Reason<"dot", &FaceTested::dot, field::required>,
        field::Told<"cosine", &FaceTested::cosine, field::or_null>,
        field::Key<"by", &FaceTested::by>, field::Decision<"culled", &FaceTested::culled>,
        field::Told<"opposite", &FaceTested::opposite>>;
};

/// The light on a face is known.
template <typename Number = Quantity> struct FaceLit {
    static constexpr StepKind step_kind = StepKind::light;

    held::NameOfPrimitive<Number> name = {};
    held::Vector<Number, 3> normal = {};
    held::Vector<Number, 3> light = {};  ///< toward the light, from the face's centroid
    Number dot = {};                     ///< normal . light
    held::Cosine<Number> intensity = {}; ///< of the angle between them, 0 if it is negative
    held::Color<Number> color = {};      ///< of the face in this light

    using Fields =
        FieldTable<field::Key<"name", &FaceLit::name>, field::Reason<"normal", &FaceLit::normal>,
                   field::Reason<"light", &FaceLit::light>, field::Reason<"dot", &FaceLit::dot>,
                   field::Told<"intensity", &FaceLit::intensity, field::required>,
                   field::Decision<"color", &FaceLit::color>>;
};

/// A primitive with a vertex outside a plane of the space that can be seen met that plane.
template <typename Number = Quantity> struct PrimitiveClipped {
    static constexpr StepKind step_kind = StepKind::clip;

    held::Name<Number> name = {};  ///< of the primitive; the sides of an outline come one by one
    held::Name<Number> plane = {}; ///< near, far, left, right, bottom or top
    held::List<Number, held::Flag<Number>> inside =
        {};                              ///< of its vertices so far, those on the plane included
    held::Maybe<Number, Index> out = {}; ///< how many vertices it has now

    using Fields = FieldTable<field::Key<"name", &PrimitiveClipped::name>,
                              field::Key<"plane", &PrimitiveClipped::plane, field::required>,
                              field::Decision<"inside", &PrimitiveClipped::inside>,
                              field::Decision<"out", &PrimitiveClipped::out>>;
};

/// An edge is set up. For a fill by rows, how far x moves when y grows by 1; for one by edge
/// functions, a function that is 0 on the edge, positive on the triangle's side of it and negative
/// on the other: a (x - x1) + b (y - y1), in square pixels (edge_function.h); for lines, a side is
/// about to be drawn.
template <typename Number = Quantity> struct EdgeSetUp {
    static constexpr StepKind step_kind = StepKind::edge;

    held::Edge<Number> edge =
        {}; ///< from its upper vertex (x1, y1) to its lower one, as seen in the picture
    held::Maybe<Number, held::OrNull<Number, Number>> dx_dy =
        {}; ///< (x2 - x1)/(y2 - y1); null: it is horizontal
    held::Maybe<Number, Number> a = {};
    held::Maybe<Number, Number> b = {};
    held::Maybe<Number, held::Flag<Number>> top_left =
        {};                                 ///< a sample on the edge belongs to the triangle
    held::Maybe<Number, Index> octant = {}; ///< of a side, see octant_of

    using Fields = FieldTable<field::Key<"edge", &EdgeSetUp::edge, field::required>,
                              field::Reason<"dx_dy", &EdgeSetUp::dx_dy, field::or_null>,
                              field::Reason<"a", &EdgeSetUp::a>, field::Reason<"b", &EdgeSetUp::b>,
                              field::Decision<"top_left", &EdgeSetUp::top_left>,
                              field::Decision<"octant", &EdgeSetUp::octant>>;
};

/// One of the two halves of a triangle is about to be filled.
template <typename Number = Quantity> struct HalfBegan {
    static constexpr StepKind step_kind = StepKind::half;

    held::Name<Number> half = {};           ///< upper or lower
    held::Maybe<Number, Index> from_y = {}; ///< its first row, and
    held::Maybe<Number, Index> to_y =
        {}; ///< its last; it has no row if they are in the wrong order

    using Fields = FieldTable<field::Key<"half", &HalfBegan::half, field::required>,
                              field::Decision<"from_y", &HalfBegan::from_y>,
                              field::Decision<"to_y", &HalfBegan::to_y>>;
};

/// A line of the fan begins at this pixel.
template <typename Number = Quantity> struct RayBegan {
    static constexpr StepKind step_kind = StepKind::ray;

    Index x = 0;
    Index y = 0;

    using Fields = FieldTable<field::Key<"x", &RayBegan::x, field::required>,
                              field::Key<"y", &RayBegan::y, field::required>>;
};

/// The edges of a polygon that a row meets are known, from left to right. The polygon's inside lies
/// between two of them where the winding number says so.
template <typename Number = Quantity> struct RowCrossed {
    static constexpr StepKind step_kind = StepKind::crossings;

    held::Coordinate<Number> y = 0;
    held::List<Number, held::Edge<Number>> edges = {}; ///< each from its upper to its lower vertex
    held::List<Number, Number> x = {};                 ///< of each on this row
    held::List<Number, held::Whole<Number>> winding =
        {}; ///< right of each: how often the polygon runs around

    using Fields =
        FieldTable<field::Key<"y", &RowCrossed::y, field::required>,
                   field::Reason<"edges", &RowCrossed::edges>, field::Reason<"x", &RowCrossed::x>,
                   field::Decision<"winding", &RowCrossed::winding>>;
};

/// The two ends of a row are known, or of one of the spans that a polygon has in a row.
template <typename Number = Quantity> struct ScanlineSpanned {
    static constexpr StepKind step_kind = StepKind::scanline;

    held::Coordinate<Number> y = 0;
    Number left = {};  ///< x of the left edge on this row
    Number right = {}; ///< x of the right edge on this row
    Index from = 0;    ///< first pixel of the span: left, rounded
    Index to = 0;      ///< last pixel of the span: right, rounded; empty when to < from
    held::Edge<Number> left_edge = {};
    held::Edge<Number> right_edge = {};
    held::Maybe<Number, DepthOf<Number>> left_depth = {}; ///< where depths are interpolated by rows
    held::Maybe<Number, DepthOf<Number>> right_depth = {};

    using Fields = FieldTable<field::Key<"y", &ScanlineSpanned::y, field::required>,
                              field::Reason<"left", &ScanlineSpanned::left, field::required>,
                              field::Reason<"right", &ScanlineSpanned::right, field::required>,
                              field::Decision<"from", &ScanlineSpanned::from, field::required>,
                              field::Decision<"to", &ScanlineSpanned::to, field::required>,
                              field::Reason<"left_edge", &ScanlineSpanned::left_edge>,
                              field::Reason<"right_edge", &ScanlineSpanned::right_edge>,
                              field::Reason<"left_depth", &ScanlineSpanned::left_depth>,
                              field::Reason<"right_depth", &ScanlineSpanned::right_depth>>;
};

/// A line's minor coordinate is known at a step along its major one.
template <typename Number = Quantity> struct LineSampled {
    static constexpr StepKind step_kind = StepKind::along;

    held::Maybe<Number, Index> x = {}; ///< of the step, if the line goes from column to column,
    held::Maybe<Number, Index> y = {}; ///< or if it goes from row to row
    Number value = {};                 ///< the other coordinate on the line
    Index pixel = 0;                   ///< the same, rounded

    using Fields = FieldTable<field::Key<"x", &LineSampled::x>, field::Key<"y", &LineSampled::y>,
                              field::Reason<"value", &LineSampled::value, field::required>,
                              field::Decision<"pixel", &LineSampled::pixel, field::required>>;
};

/// The step of a line at the coordinate `along` of its major axis.
template <typename Number>
LineSampled<Number> line_sampled(bool is_x_major, Index along, const Number& value, Index pixel) {
    return {.x = is_x_major ? std::optional(along) : std::nullopt,
            .y = is_x_major ? std::nullopt : std::optional(along),
            .value = value,
            .pixel = pixel};
}

/// Where a line goes next: E is x + 1, N is y + 1, whichever way y points on the canvas.
enum class Move { e, ne, n, nw, w, sw, s, se };

/// Bresenham's line has decided where to go from a pixel, or a circle from one of its octant that
/// begins at the largest y; that one may lie off the canvas.
template <typename Number = Quantity> struct LineDecided {
    static constexpr StepKind step_kind = StepKind::decide;

    held::Coordinate<Number> x = 0;
    held::Coordinate<Number> y = 0;
    held::Whole<Number> d = {}; ///< straight on if d <= 0, of a circle if d < 0; else diagonally
    held::Word<Number, Move> move = {};

    using Fields = FieldTable<field::Key<"x", &LineDecided::x, field::required>,
                              field::Key<"y", &LineDecided::y, field::required>,
                              field::Reason<"d", &LineDecided::d, field::required>,
                              field::Decision<"move", &LineDecided::move, field::required>>;
};

/// A sample point met a triangle.
template <typename Number = Quantity> struct SampleTested {
    static constexpr StepKind step_kind = StepKind::sample;

    held::Coordinate<Number> x = 0;
    held::Coordinate<Number> y = 0;
    held::Array<Number, Number, 3> weights =
        {};                         ///< of the vertices, in the scene's order; they sum to 1
    held::Flag<Number> inside = {}; ///< none is negative

    Pixel pixel() const { return {x, y}; }

    using Fields = FieldTable<field::Key<"x", &SampleTested::x, field::required>,
                              field::Key<"y", &SampleTested::y, field::required>,
                              field::Reason<"weights", &SampleTested::weights>,
                              field::Decision<"inside", &SampleTested::inside>>;
};

/// A pixel met the depth buffer. Of equal depths the first one stays, but what is thinner passes: a
/// line before a face, a point before both. Points and lines are kept apart from faces
/// (line_painter.h). What decides is the depth that is stored, unless the step names another
/// primitive that does.
template <typename Number = Quantity> struct DepthTested {
    static constexpr StepKind step_kind = StepKind::depth;

    held::Coordinate<Number> x = 0;
    held::Coordinate<Number> y = 0;
    Number depth = {}; ///< of the primitive at this pixel
    /// Of the nearest face, point or line; of the nearest point or line if that decides; none if
    /// nothing was drawn, and no number is farther.
    held::OrNull<Number, Number> stored = {};
    held::Flag<Number> pass = {};
    held::Maybe<Number, held::Name<Number>> side_of =
        {}; ///< it passes what is nearer in the pixel, being a side or a corner of that
    held::Maybe<Number, held::Name<Number>> beside =
        {}; ///< it passes a face that is nearer in the pixel, but does not cover the line's own
            ///< point, or is not nearer there
    held::Maybe<Number, held::Name<Number>> behind =
        {}; ///< a face in the pixel, or next to it, covers the line's own point and is nearer there

    Pixel pixel() const { return {x, y}; }
    bool is_by_stored() const { return !side_of && !beside && !behind; }

    using Fields = FieldTable<field::Key<"x", &DepthTested::x, field::required>,
                              field::Key<"y", &DepthTested::y, field::required>,
                              field::Reason<"depth", &DepthTested::depth, field::required>,
                              field::Reason<"stored", &DepthTested::stored, field::or_null>,
                              field::Decision<"pass", &DepthTested::pass>,
                              field::Reason<"side_of", &DepthTested::side_of>,
                              field::Reason<"beside", &DepthTested::beside>,
                              field::Reason<"behind", &DepthTested::behind>>;
};

/// A pixel got a color.
template <typename Number = Quantity> struct PixelPlotted {
    static constexpr StepKind step_kind = StepKind::pixel;

    held::Coordinate<Number> x = 0;
    held::Coordinate<Number> y = 0;
    held::Color<Number> color = {};

    Pixel pixel() const { return {x, y}; }

    using Fields = FieldTable<field::Key<"x", &PixelPlotted::x, field::required>,
                              field::Key<"y", &PixelPlotted::y, field::required>,
                              field::Decision<"color", &PixelPlotted::color>>;
};

/// Pixels were dropped: one, those in a row or one behind the other on a line, from the first to
/// the last; or whole rows, from the upper one to the lower one.
template <typename Number = Quantity> struct PixelsRejected {
    static constexpr StepKind step_kind = StepKind::reject;

    held::Maybe<Number, Index> x = {};    ///< none: of whole rows
    held::Maybe<Number, Index> to_x = {}; ///< of more than one pixel
    held::Maybe<Number, Index> y = {};
    held::Maybe<Number, Index> to_y = {}; ///< if that is another row
    held::Name<Number> why = {};          ///< off-canvas

    using Fields =
        FieldTable<field::Key<"x", &PixelsRejected::x>, field::Key<"to_x", &PixelsRejected::to_x>,
                   field::Key<"y", &PixelsRejected::y>, field::Key<"to_y", &PixelsRejected::to_y>,
                   field::Decision<"why", &PixelsRejected::why, field::required>>;
};

/// The canvas has none of the pixels from one to another.
inline PixelsRejected<> pixels_off_canvas(Index x, Index y, Index to_x, Index to_y) {
    const bool is_in_row = y == to_y;
    return {.x = x,
            .to_x = is_in_row && x == to_x ? std::nullopt : std::optional(to_x),
            .y = y,
            .to_y = is_in_row ? std::nullopt : std::optional(to_y),
            .why = "off-canvas"};
}

/// The canvas has none of the rows from one to another.
inline PixelsRejected<> rows_off_canvas(Index y, Index to_y) {
    return {.y = y, .to_y = to_y, .why = "off-canvas"};
}

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
template <typename Number = Quantity> struct PrimitiveSkipped {
    static constexpr StepKind step_kind = StepKind::skip;

    held::NameOfPrimitive<Number> name = {};
    held::Word<Number, SkipReason> why = {};

    using Fields = FieldTable<field::Key<"name", &PrimitiveSkipped::name>,
                              field::Decision<"why", &PrimitiveSkipped::why, field::required>>;
};

/// Intervals of doubles leave a decision about a primitive open, so all of it is drawn in fractions.
/// Fires before its first step.
template <typename Number = Quantity> struct BoundExceeded {
    static constexpr StepKind step_kind = StepKind::undecided;

    held::Name<Number> name = {}; ///< of the primitive, or of the part of one
    held::Maybe<Number, held::Cosine<Number>> difference = {}; ///< of the two, as it was calculated
    held::Maybe<Number, held::Cosine<Number>> error = {};      ///< that it may be off by

    using Fields = FieldTable<field::Key<"name", &BoundExceeded::name>,
                              field::Reason<"difference", &BoundExceeded::difference>,
                              field::Reason<"error", &BoundExceeded::error>>;
};

/// A step of any kind, in the order of StepKind: the one list of them.
template <typename Number>
using AnyStepOf =
    std::variant<FaceTriangulated<Number>, MatrixSetUp<Number>, VertexPlaced<Number>,
                 PrimitivesOrdered<Number>, PrimitiveBegan<Number>, FaceTested<Number>,
                 FaceLit<Number>, PrimitiveClipped<Number>, EdgeSetUp<Number>, HalfBegan<Number>,
                 RayBegan<Number>, RowCrossed<Number>, ScanlineSpanned<Number>, LineSampled<Number>,
                 LineDecided<Number>, SampleTested<Number>, DepthTested<Number>,
                 PixelPlotted<Number>, PixelsRejected<Number>, PrimitiveSkipped<Number>,
                 BoundExceeded<Number>>;
static_assert(std::variant_size_v<AnyStepOf<Quantity>> == step_names.size());

} // namespace rastertrace
