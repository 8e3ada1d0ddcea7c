// SPDX-License-Identifier: MIT
#pragma once

// The triangles of a scene on the screen, in the numbers that its plan draws them with.

#include "job_builder.h"

#include <rastertrace/core/draw/list/pieces.h>
#include <rastertrace/core/draw/paint/piece_in.h>
#include <rastertrace/core/draw/plan/plan.h>
#include <rastertrace/core/draw/scene/scene.h>

#include <algorithm>
#include <concepts>
#include <vector>

namespace rastertrace {

/// Calls `visit(triangle)` with every triangle, culled ones too, and every part that clipping has left
/// of one. Scalar must be the one of the plan.
template <typename Scalar, typename Visit>
void for_each_placed_triangle(const Scene& scene, const Plan& plan, Visit&& visit) {
    std::visit(
        [&]<typename AList>(const AList& list) {
            if constexpr (draws<Scalar, AList>)
                for_each_piece(scene, list, [&](const auto& piece) {
                    if (piece.kind == PrimitiveKind::triangle)
                        visit(piece_in<Scalar>(piece, plan));
                });
        },
        *plan.list);
}

/// The placed triangles that are filled: neither culled nor skipped for another reason.
template <typename Scalar>
std::vector<Piece<Scalar>> triangles_to_fill(const Scene& scene, const Plan& plan) {
    std::vector<Piece<Scalar>> triangles;
    for_each_placed_triangle<Scalar>(scene, plan, [&triangles](const Piece<Scalar>& triangle) {
        if (!triangle.is_skipped)
            triangles.push_back(triangle);
    });
    return triangles;
}

/// True if these are the triangles, in order, whose pixels `spans` has. They are not if clipping, in
/// other numbers, has cut one into more parts or fewer.
inline bool are_those_of(const std::vector<SpansOfPiece>& spans,
                         const std::vector<std::size_t>& primitives) {
    return std::equal(
        primitives.begin(), primitives.end(), spans.begin(), spans.end(),
        [](std::size_t number, const SpansOfPiece& piece) { return number == piece.primitive; });
}

} // namespace rastertrace
