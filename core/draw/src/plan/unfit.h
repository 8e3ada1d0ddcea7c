// SPDX-License-Identifier: MIT
#pragma once

// Finds what would make an infinity or overflow if a scene were drawn.

#include "list/vertex_spaces.h"

#include <rastertrace/core/draw/list/pieces.h>
#include <rastertrace/core/draw/paint/piece_in.h>
#include <rastertrace/core/draw/plan/plan.h>

namespace rastertrace {

/// What a piece has that would make an infinity or overflow. `tests_lines`: the depths of lines
/// count.
std::optional<Unfit> unfit_of(const Piece<double>& piece, const Method& method, bool mixes_colors,
                              bool tests_lines);

/// True if no step of drawing a piece can overflow in fractions of 64 bits over the plan's denominator.
bool fits_fractions(const Scene& scene, const Piece<double>& piece, const Plan& plan);

/// The first unfit piece, in the scene's order.
template <typename AList> std::optional<Unfit> unfit_piece(const Scene& scene, const AList& list) {
    const bool tests_lines = scene.has_tested_lines();
    std::optional<Unfit> first;
    std::size_t primitive = scene.primitives.size();
    for_each_piece(scene, list, [&](const auto& piece) {
        if (piece.primitive >= primitive)
            return;
        const auto unfit =
            unfit_of(in_doubles(piece), scene.method, list.mixes_colors, tests_lines);
        if (unfit) {
            first = unfit;
            primitive = piece.primitive;
        }
    });
    return first;
}

/// The first triangle whose face has an infinite normal or product.
template <typename Coordinate>
std::optional<Unfit> unfit_face(const Scene& scene, const ScreenList<Coordinate>& list) {
    if (!list.infinite_face)
        return std::nullopt;
    const auto& [primitive, at] = *list.infinite_face;
    const auto corners = scene.primitives[primitive].corners();
    return Unfit{Unfit::What::face, corners[0], corners[2], at, at, 0};
}
inline std::optional<Unfit> unfit_face(const Scene&, const TypedVertices&) {
    return std::nullopt;
}

inline Unfit unfit_at(Unfit::What what, std::size_t vertex, double x, double y) {
    return {what, vertex, vertex, {x, y}, {x, y}, 0};
}

/// The first vertex that a primitive needs and that has no finite position before clipping, or no
/// depth.
template <typename Coordinate>
std::optional<Unfit> unfit_vertex(const Scene& scene, const Geometry<Coordinate>& geometry) {
    const auto is_infinite = [](const std::optional<Matrix<Coordinate>>& matrix) {
        return matrix && !all_finite(*matrix);
    };
    const auto& transforms = geometry.list.transforms;
    if (is_infinite(transforms.view) || is_infinite(transforms.projection) ||
        is_infinite(transforms.viewport) ||
        std::any_of(transforms.models.begin(), transforms.models.end(), is_infinite))
        return Unfit{Unfit::What::matrix, 0, 0, {}, {}, 0};
    for (std::size_t i = 0; i < geometry.vertices.size(); ++i) {
        const auto& at = geometry.vertices[i].clip;
        if (geometry.is_used[i] &&
            !(is_finite(at.x) && is_finite(at.y) && is_finite(at.z) && is_finite(at.w)))
            return unfit_at(Unfit::What::position, i, to_double(at.x), to_double(at.y));
    }
    // In a perspective, clipping leaves only what lies in front of the eye. Elsewhere nothing does.
    const bool tests_all = scene.has_depth_buffer();
    if (scene.depth() == Depth::inverse_z && !is_perspective(scene.projection.type))
        for (const ScenePrimitive& primitive : scene.primitives)
            if (is_filled(primitive.kind) || tests_all)
                for (const std::size_t i : primitive.corners()) {
                    const Coordinate& exact = geometry.vertices[i].distance;
                    const double distance = to_double(exact);
                    if (!(scalar_from<Coordinate>(0) < exact) || !std::isfinite(1 / distance))
                        return unfit_at(Unfit::What::depth, i, distance, 0);
                }
    return std::nullopt;
}
inline std::optional<Unfit> unfit_vertex(const Scene&, const TypedVertices&) {
    return std::nullopt;
}

} // namespace rastertrace
