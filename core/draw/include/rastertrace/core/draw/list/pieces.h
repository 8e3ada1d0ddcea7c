// SPDX-License-Identifier: MIT
#pragma once

// From vertices in clip space to a list of what is drawn on the screen: faces are tested and lit,
// primitives are clipped, each once. A piece is a primitive, or a part of one that clipping has
// cut.
//
//     const auto list = screen_list_of(scene, geometry_of<double>(scene));
//     for_each_piece(scene, list, [](const Piece<double>& piece) { /* draw it */ });
//
// The list does not hold what is not drawn, like normals: it is worked out again for a listener.

#include <rastertrace/core/draw/list/geometry.h>
#include <rastertrace/core/draw/list/screen_list.h>
#include <rastertrace/core/draw/scene/scene.h>
#include <rastertrace/core/draw/tell/listener.h>
#include <rastertrace/core/numbers/conversion.h>
#include <rastertrace/core/numbers/vec.h>
#include <rastertrace/core/raster/depth_buffer.h>
#include <rastertrace/core/raster/image.h>
#include <rastertrace/core/raster/steps.h>

#include <array>
#include <cstddef>
#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace rastertrace {

/// The tests of a face, before it is clipped.
template <typename Coordinate> struct Face {
    std::optional<FaceTested<Coordinate>> tested = {};
    std::optional<FaceLit<Coordinate>> lit = {};
    std::optional<SkipReason> skip = {}; ///< why it is not drawn
};

/// Tells the tests of a face. True if it is drawn.
template <typename Coordinate, typename Sink>
bool tell_face(const Face<Coordinate>& face, Sink&& sink) {
    if (face.tested)
        sink(*face.tested);
    if (face.lit)
        sink(*face.lit);
    if (face.skip)
        sink(PrimitiveSkipped<>{.why = *face.skip});
    return !face.skip;
}

/// Of vertices as typed: no face is tested.
struct NoFace {};
template <typename Sink> bool tell_face(NoFace, Sink&&) {
    return true;
}

/// Which depths pass the test, and the depth that the buffer is cleared to: none if any depth
/// passes against it.
template <typename Scalar> DepthRule<Scalar> depth_rule(const Scene& scene) {
    DepthRule<Scalar> rule;
    const Depth depth = scene.depth();
    const Projection& projection = scene.projection;
    if (depth == Depth::inverse_z)
        rule = {.larger_passes = true, .cleared = scalar_from<Scalar>(0)};
    else if (depth == Depth::ndc_z && projection.type == ProjectionType::view_plane)
        rule = {.larger_passes = true,
                .cleared = Scalar(-scalar_from<Scalar>(projection.distance))};
    else if (depth == Depth::ndc_z &&
             (is_perspective(projection.type) ||
              (projection.type == ProjectionType::orthographic && projection.near)))
        rule.cleared = scalar_from<Scalar>(1);
    if (depth == Depth::ndc_z && scene.viewport.depths)
        rule = {.larger_passes = scene.viewport.has_reversed_depths(),
                .cleared = scalar_from<Scalar>(scene.viewport.depths->far)};
    if (scene.method.depth_compare != DepthCompare::automatic) {
        const bool larger = scene.method.depth_compare == DepthCompare::greater;
        if (larger != rule.larger_passes)
            rule = {.larger_passes = larger, .cleared = std::nullopt};
    }
    return rule;
}

/// A primitive on the screen, or a part of one: the first `count` elements of each array. A polygon
/// has its corners in the rings; it has neither depths nor colors of vertices.
template <typename Coordinate> struct Piece {
    PrimitiveKind kind;        ///< a line, if it is a part of an outline
    std::size_t primitive = 0; ///< its index in the scene
    Color color;               ///< of the primitive
    bool is_part = false;
    bool is_skipped = false; ///< its face is not drawn
    std::size_t count = 0;
    std::array<Vec<Coordinate, 2>, 3> positions{};
    std::array<DepthOf<Coordinate>, 3> depths{};    ///< if there is a depth buffer
    std::array<DepthOf<Coordinate>, 3> inverse_w{}; ///< if colors are mixed
    std::array<Color, 3> colors;                    ///< the primitive's, where a vertex has none
    /// In the place of these, of all corners, if clipping has cut an edge between two colors.
    std::vector<Levels<DepthOf<Coordinate>>> levels = {};
    /// Indices in the scene. A vertex that clipping has made has the first vertex of what was
    /// clipped.
    std::array<std::size_t, 3> vertices{};
    Index radius = 0;                          ///< around its vertex, in pixels, if it has one
    std::vector<Vec<Coordinate, 2>> ring = {}; ///< of a polygon: the positions of all its corners
    std::vector<std::size_t> ring_vertices = {};

    std::span<const Vec<Coordinate, 2>> corners() const {
        return traits_of(kind).has_ring ? std::span(ring) : std::span(positions).first(count);
    }
    std::size_t vertex(std::size_t corner) const {
        return traits_of(kind).has_ring ? ring_vertices[corner] : vertices[corner];
    }
};

/// A piece with other numbers: all of `piece` but its positions, depths and 1/w.
template <typename Coordinate, typename Other>
Piece<Coordinate> without_numbers(const Piece<Other>& piece) {
    return {.kind = piece.kind,
            .primitive = piece.primitive,
            .color = piece.color,
            .is_part = piece.is_part,
            .is_skipped = piece.is_skipped,
            .count = piece.count,
            .colors = piece.colors,
            .vertices = piece.vertices,
            .radius = piece.radius,
            .ring_vertices = piece.ring_vertices};
}

/// The names of a piece and of its corners: "ABC/1" for a part, "ABC:1" for a vertex that clipping
/// has made.
class PieceNames {
public:
    PieceNames(const Scene& scene, const std::vector<MadeVertex>& made,
               const std::vector<ScreenPart>& parts, const ScreenPrimitive& one);
    template <typename Coordinate>
    PieceNames(const Scene& scene, const ScreenList<Coordinate>& list, const ScreenPrimitive& one)
        : PieceNames(scene, list.made, list.parts, one) {}
    PieceNames(const Scene& scene, const TypedVertices&, const ScreenPrimitive& one)
        : PieceNames(scene, {}, {}, one) {}
    PieceNames(const PieceNames&) = delete;
    PieceNames& operator=(const PieceNames&) = delete;

    std::string_view piece;
    std::vector<std::string_view> corners;

private:
    std::vector<std::string> made_; ///< names that the scene does not have
};

/// The list of all primitives, in the order in which they are drawn.
template <typename Scalar>
ScreenList<Scalar> screen_list_of(const Scene& scene, Geometry<Scalar> geometry);
inline TypedVertices screen_list_of(const Scene&, TypedVertices typed) {
    return typed;
}

/// Tests and lights the face of a primitive, clips it, and adds what is left of it to the list.
/// Only for Rational.
template <typename Scalar>
void add_primitive(const Scene& scene, Geometry<Scalar>& geometry, std::size_t index);

/// Tests and lights a face; `world` are its corners in the world. A face without area has no normal
/// and is skipped. Only for Rational.
template <typename Scalar>
Face<Scalar> face_of(const Scene& scene, const Transforms<Scalar>& transforms,
                     const ScenePrimitive& primitive, std::span<const Vec<Scalar, 3>> world);

/// An entry of the list with its corners.
template <typename Scalar>
Piece<Scalar> piece_of(const Scene& scene, const ScreenList<Scalar>& list,
                       const ScreenPrimitive& one);
Piece<Number> piece_of(const Scene& scene, const TypedVertices& typed, const ScreenPrimitive& one);

/// Takes the face of a piece.
template <typename Scalar> using TakeFace = std::function<void(const Face<Scalar>& face)>;

/// Tells how a primitive is tested and clipped, and calls `draw_next(face)` for each of its pieces
/// in the list, when it is its turn to be drawn. The face of a part has been told before.
template <typename Scalar>
void tell_pieces(const Scene& scene, const ScreenList<Scalar>& list, std::size_t index,
                 const Listener& listener, const TakeFace<Scalar>& draw_next);

// Vertices as typed have no list. Its entries are made when they are asked for.

/// The entry of a primitive that is drawn as typed.
ScreenPrimitive typed_primitive(const Scene& scene, std::size_t index);

/// The number of entries.
template <typename Scalar> std::size_t count_of(const Scene&, const ScreenList<Scalar>& list) {
    return list.primitives.size();
}
inline std::size_t count_of(const Scene& scene, const TypedVertices&) {
    return scene.primitives.size();
}

/// The entry with this index.
template <typename Scalar>
const ScreenPrimitive& nth_of(const Scene&, const ScreenList<Scalar>& list, std::size_t index) {
    return list.primitives[index];
}
inline ScreenPrimitive nth_of(const Scene& scene, const TypedVertices&, std::size_t index) {
    return typed_primitive(scene, index);
}

/// Calls `visit(one)` with each entry of the list.
template <typename AList, typename Visit>
void for_each_primitive(const Scene& scene, const AList& list, Visit&& visit) {
    for (std::size_t i = 0; i < count_of(scene, list); ++i)
        visit(nth_of(scene, list, i));
}

/// The same for a listener, who is told first how each primitive is tested and clipped: `visit(one,
/// face)`.
template <typename Scalar, typename Visit>
void tell_all_pieces(const Scene& scene, const ScreenList<Scalar>& list, const Listener& listener,
                     Visit&& visit) {
    auto next = list.primitives.begin();
    for (std::size_t turn = 0; turn < scene.primitives.size(); ++turn)
        tell_pieces<Scalar>(scene, list, primitive_at(list, turn), listener,
                            [&](const Face<Scalar>& face) { visit(*next++, face); });
}
template <typename Visit>
void tell_all_pieces(const Scene& scene, const TypedVertices& typed, const Listener&,
                     Visit&& visit) {
    for_each_primitive(scene, typed, [&](const ScreenPrimitive& one) { visit(one, NoFace()); });
}

/// Calls `visit(piece)` with each entry of the list that is not undecided.
template <typename AList, typename Visit>
void for_each_piece(const Scene& scene, const AList& list, Visit&& visit) {
    for_each_primitive(scene, list, [&](const ScreenPrimitive& one) {
        if (one.state != ScreenPrimitive::State::undecided)
            visit(piece_of(scene, list, one));
    });
}

} // namespace rastertrace
