// SPDX-License-Identifier: MIT
#pragma once

// From primitives whose vertices have their places to pieces that lie on the screen: faces are
// tested and lit, what reaches out of view is clipped.
//
//     for_each_piece(scene, geometry, [](const Piece<double>& piece) { /* draw it */ });

#include <rastertrace/core/depth.h>
#include <rastertrace/core/face.h>
#include <rastertrace/core/geometry.h>
#include <rastertrace/core/image.h>
#include <rastertrace/core/listener.h>
#include <rastertrace/core/scalar.h>
#include <rastertrace/core/scene.h>
#include <rastertrace/core/steps.h>
#include <rastertrace/core/vec.h>

#include <array>
#include <cstddef>
#include <functional>
#include <optional>
#include <string_view>
#include <type_traits>

namespace rastertrace {

/// What was found out about a triangle's face before it is clipped.
template <typename Coordinate> struct Face {
    std::optional<FaceTested<Coordinate>> tested = {};
    std::optional<FaceLit<Coordinate>> lit = {};
    std::optional<SkipReason> skip = {}; ///< then it is not drawn
};

/// Reports what was found out about a face. True if it is to be drawn.
template <typename Coordinate, typename Sink>
bool report_face(const Face<Coordinate>& face, Sink&& sink) {
    if (face.tested)
        sink(*face.tested);
    if (face.lit)
        sink(*face.lit);
    if (face.skip)
        sink(PrimitiveSkipped{.why = *face.skip});
    return !face.skip;
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
    PrimitiveKind kind;
    std::string_view name;
    std::size_t primitive = 0; ///< its place in the scene
    Color color;               ///< of the primitive
    std::size_t count = 0;
    std::array<std::string_view, 3> names;
    std::array<Vec<Coordinate, 2>, 3> positions{};
    std::array<DepthOf<Coordinate>, 3> depths{};    ///< if there is a depth buffer
    std::array<DepthOf<Coordinate>, 3> inverse_w{}; ///< if colors mix in a perspective
    std::array<Color, 3> colors;                    ///< the primitive's, where a vertex has none
    std::array<std::size_t, 3> vertices{}; ///< places in the scene of the vertices, or of the
                                           ///< primitive's first one if clipping made them
    bool is_part = false;
    Face<Coordinate> face = {}; ///< of a triangle that is no part
};

/// The primitives in the order in which they are drawn: the scene's, or the painter's.
template <typename Scalar>
std::size_t primitive_at(const Geometry<Scalar>& geometry, std::size_t turn) {
    return geometry.order ? geometry.order->primitives[turn] : turn;
}
inline std::size_t primitive_at(const TypedGeometry&, std::size_t turn) {
    return turn;
}

/// What takes the pieces of primitives whose vertices lie at coordinates of this type.
template <typename Coordinate>
using PieceVisitor = std::function<void(const Piece<Coordinate>& piece)>;

// What follows is compiled in the library, for float, double, Adaptive and Rational.

/// Tests which way a triangle is turned, and lights it. A triangle without area has no normal.
template <typename Scalar>
Face<Scalar> face_of(const Scene& scene, const Geometry<Scalar>& geometry,
                     const ScenePrimitive& primitive);

/// Visits the pieces of a primitive. In view it is one; what clips it is told. Without a pipeline every
/// primitive is one piece.
template <typename Scalar>
void visit_pieces(const Scene& scene, const Geometry<Scalar>& geometry, std::size_t number,
                  bool mixes_colors, const Listener& listener,
                  const std::type_identity_t<PieceVisitor<Scalar>>& visit);
void visit_pieces(const Scene& scene, const TypedGeometry& geometry, std::size_t number,
                  bool mixes_colors, const Listener& listener, const PieceVisitor<Number>& visit);

/// Visits the pieces of all primitives, in the order in which they are drawn.
template <typename Scalar>
void for_each_piece(const Scene& scene, const Geometry<Scalar>& geometry,
                    const std::type_identity_t<PieceVisitor<Scalar>>& visit,
                    const Listener& listener = {});
void for_each_piece(const Scene& scene, const TypedGeometry& geometry,
                    const PieceVisitor<Number>& visit, const Listener& listener = {});

} // namespace rastertrace
