// SPDX-License-Identifier: MIT
#pragma once

// From primitives whose vertices have their places to a list of what is drawn on the screen: faces are
// tested and lit, what reaches out of view is clipped, each once.
//
//     const auto list = screen_list_of(scene, geometry_of<double>(scene));
//     for_each_piece(scene, list, [](const Piece<double>& piece) { /* draw it */ });
//
// What is found out on the way and is not drawn, like normals, is worked out again for who listens.

#include <rastertrace/core/draw/list/geometry.h>
#include <rastertrace/core/draw/list/screen_list.h>
#include <rastertrace/core/draw/scene/scene.h>
#include <rastertrace/core/draw/tell/listener.h>
#include <rastertrace/core/numbers/adaptive.h>
#include <rastertrace/core/numbers/conversion.h>
#include <rastertrace/core/numbers/vec.h>
#include <rastertrace/core/raster/depth_buffer.h>
#include <rastertrace/core/raster/image.h>
#include <rastertrace/core/raster/shading.h>
#include <rastertrace/core/raster/steps.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <functional>
#include <optional>
#include <string>
#include <string_view>

namespace rastertrace {

/// What was found out about a triangle's face before it is clipped.
template <typename Coordinate> struct Face {
    std::optional<FaceTested<Coordinate>> tested = {};
    std::optional<FaceLit<Coordinate>> lit = {};
    std::optional<SkipReason> skip = {}; ///< then it is not drawn
};

/// Tells what was found out about a face. True if it is to be drawn.
template <typename Coordinate, typename Sink>
bool tell_face(const Face<Coordinate>& face, Sink&& sink) {
    if (face.tested)
        sink(*face.tested);
    if (face.lit)
        sink(*face.lit);
    if (face.skip)
        sink(PrimitiveSkipped{.why = *face.skip});
    return !face.skip;
}

/// Without a pipeline, faces are not looked at.
struct NoFace {};
template <typename Sink> bool tell_face(NoFace, Sink&&) {
    return true;
}

/// Which depths pass, and what the buffer starts at.
template <typename Scalar> DepthRule<Scalar> depth_rule(const Scene& scene) {
    DepthRule<Scalar> rule;
    const Depth depth = scene.depth();
    if (depth == Depth::inverse_z)
        rule = {.larger_passes = true, .cleared = scalar_from<Scalar>(0)};
    if (depth == Depth::ndc_z)
        switch (scene.projection.type) {
        case ProjectionType::view_plane:
            rule = {.larger_passes = true,
                    .cleared = Scalar(-scalar_from<Scalar>(scene.projection.distance))};
            break;
        case ProjectionType::pinhole:
        case ProjectionType::frustum:
            rule.cleared = scalar_from<Scalar>(1);
            break;
        case ProjectionType::orthographic:
            if (scene.projection.near)
                rule.cleared = scalar_from<Scalar>(1);
            break;
        case ProjectionType::none:
            break;
        }
    if (scene.method.depth_compare != DepthCompare::automatic) {
        const bool larger = scene.method.depth_compare == DepthCompare::greater;
        if (larger != rule.larger_passes)
            rule = {.larger_passes = larger, .cleared = std::nullopt};
    }
    return rule;
}

/// A primitive on the screen, or a part of one that clipping has cut: the first `count` of each.
template <typename Coordinate> struct Piece {
    PrimitiveKind kind;        ///< of a part of an outline: a line
    std::size_t primitive = 0; ///< its index in the scene
    Color color;               ///< of the primitive
    bool is_part = false;
    bool is_skipped = false; ///< its face is not drawn
    std::size_t count = 0;
    std::array<Vec<Coordinate, 2>, 3> positions{};
    std::array<DepthOf<Coordinate>, 3> depths{};    ///< if there is a depth buffer
    std::array<DepthOf<Coordinate>, 3> inverse_w{}; ///< if colors are mixed
    std::array<Color, 3> colors;                    ///< the primitive's, where a vertex has none
    std::array<std::size_t, 3> vertices{}; ///< indices in the scene of the vertices, or of the
                                           ///< first one of what was clipped if clipping made them
};

/// What is called how: a part "ABC/1", and a vertex that clipping has made "ABC:1".
class PieceNames {
public:
    PieceNames(const Scene& scene, const TypedVertices& typed, const ScreenPrimitive& one);
    template <typename Coordinate>
    PieceNames(const Scene& scene, const ScreenList<Coordinate>& list, const ScreenPrimitive& one);
    PieceNames(const PieceNames&) = delete;
    PieceNames& operator=(const PieceNames&) = delete;

    std::string_view piece;
    std::array<std::string_view, 3> corners;

private:
    std::array<std::string, 4> made_; ///< those that the scene does not have
};

// What follows is compiled in the library. What is asked for primitive by primitive: for Rational.

/// Tests which way a triangle is turned, and lights it. `world` are its corners there. A triangle without
/// area has no normal.
template <typename Scalar>
Face<Scalar> face_of(const Scene& scene, const Transforms<Scalar>& transforms,
                     const ScenePrimitive& primitive, const std::array<Vec<Scalar, 3>, 3>& world);

/// Tests and lights the face of a primitive, clips it, and adds what is left of it to the list.
template <typename Scalar>
void add_primitive(const Scene& scene, Geometry<Scalar>& geometry, std::size_t index);

// For float, double, Adaptive and Rational:

/// What is drawn of all primitives, in the order in which they are drawn.
template <typename Scalar>
ScreenList<Scalar> screen_list_of(const Scene& scene, Geometry<Scalar> geometry);
inline TypedVertices screen_list_of(const Scene&, TypedVertices typed) {
    return typed;
}

/// One of the list with its corners.
template <typename Scalar>
Piece<Scalar> piece_of(const Scene& scene, const ScreenList<Scalar>& list,
                       const ScreenPrimitive& one);
Piece<Number> piece_of(const Scene& scene, const TypedVertices& typed, const ScreenPrimitive& one);

/// What takes the face of each piece.
template <typename Scalar> using TakeFace = std::function<void(const Face<Scalar>& face)>;

/// Tells what is found out about a primitive before it is on the screen, and calls `draw_next(face)` for
/// each of its pieces in the list, when it is their turn. The face of a part has been told.
template <typename Scalar>
void tell_pieces(const Scene& scene, const ScreenList<Scalar>& list, std::size_t index,
                 const Listener& listener, const TakeFace<Scalar>& draw_next);

// Without a list, what it would hold is made as it is asked for.

/// What the list would hold of a primitive.
ScreenPrimitive typed_primitive(const Scene& scene, std::size_t index);

/// How many the list holds.
template <typename Scalar> std::size_t count_of(const Scene&, const ScreenList<Scalar>& list) {
    return list.primitives.size();
}
inline std::size_t count_of(const Scene& scene, const TypedVertices&) {
    return scene.primitives.size();
}

/// The one at a place in the list.
template <typename Scalar>
const ScreenPrimitive& nth_of(const Scene&, const ScreenList<Scalar>& list, std::size_t place) {
    return list.primitives[place];
}
inline ScreenPrimitive nth_of(const Scene& scene, const TypedVertices&, std::size_t place) {
    return typed_primitive(scene, place);
}

/// Calls `visit(one)` with each of the list.
template <typename AList, typename Visit>
void for_each_primitive(const Scene& scene, const AList& list, Visit&& visit) {
    for (std::size_t place = 0; place < count_of(scene, list); ++place)
        visit(nth_of(scene, list, place));
}

/// The same, telling what is found out about each primitive before: `visit(one, face)`.
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

/// Calls `visit(piece)` with each of the list that is decided.
template <typename AList, typename Visit>
void for_each_piece(const Scene& scene, const AList& list, Visit&& visit) {
    for_each_primitive(scene, list, [&](const ScreenPrimitive& one) {
        if (one.state != ScreenPrimitive::State::undecided)
            visit(piece_of(scene, list, one));
    });
}

} // namespace rastertrace
