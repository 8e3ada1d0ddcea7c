// SPDX-License-Identifier: MIT
#include <rastertrace/core/draw/filtered/exactly.h>

#include "hidden-lines/line_painter.h"

#include <rastertrace/core/raster/edge.h>
#include <rastertrace/core/raster/fill_scanline.h>

#include <algorithm>
#include <cmath>

namespace rastertrace {

namespace {

/// The two edges at the ends of a row.
template <typename Scalar> struct EdgesOfRow {
    Edge<Scalar> left;
    Edge<Scalar> right;
};
template <typename Scalar>
EdgesOfRow<Scalar> edges_of_row(const Triangle<Scalar>& triangle, int y,
                                const SampleOffset<Scalar>& offset, int down) {
    const JoinedEdges<Scalar> edges = joined_edges(triangle, down);
    const bool is_lower = first_lower_y(edges, offset, down) * down <= Index{y} * down;
    const Edge<Scalar>& short_edge = is_lower ? edges.lower : edges.upper;
    return edges.long_edge_is_left ? EdgesOfRow<Scalar>{edges.long_edge, short_edge}
                                   : EdgesOfRow<Scalar>{short_edge, edges.long_edge};
}

/// True if the fill that the scene names finds depths along the edges; else they lie in a plane.
bool finds_depths_along_edges(const Scene& scene) {
    return traits_of(scene.method.fill).depths == DepthForm::along_edges;
}

} // namespace

std::span<const ScreenPrimitive> ExactPieces::parts_of(std::size_t primitive) {
    if (!geometry_) {
        geometry_ = empty_geometry<Rational>(scene_);
        std::visit(
            [this]<typename AList>(const AList& list) {
                if constexpr (!std::same_as<AList, TypedVertices>) {
                    auto& transforms = geometry_->list.transforms;
                    transforms.divides = list.transforms.divides;
                    geometry_->list.culled_sides = list.culled_sides;
                    // Planes that cross no primitive need not be tested.
                    const auto& kept = list.transforms.planes;
                    std::erase_if(transforms.planes, [&kept](const auto& plane) {
                        return std::none_of(kept.begin(), kept.end(), [&plane](const auto& other) {
                            return other.name == plane.name;
                        });
                    });
                }
            },
            *plan_.list);
    }
    auto& drawn = geometry_->list.primitives;
    const auto [known, is_new] = ranges_.try_emplace(primitive);
    Range& range = known->second;
    if (is_new) {
        for (const std::size_t index : scene_.primitives[primitive].corners())
            if (!geometry_->is_used[index]) {
                geometry_->is_used[index] = true;
                move_vertex(scene_, index, *geometry_);
            }
        range.begin = drawn.size();
        add_primitive(scene_, *geometry_, primitive);
        range.end = drawn.size();
    }
    return std::span(drawn).subspan(range.begin, range.end - range.begin);
}

std::vector<ScreenPrimitive> ExactPieces::of(std::size_t primitive) {
    const auto parts = parts_of(primitive);
    return {parts.begin(), parts.end()};
}

Piece<Rational> ExactPieces::piece(const PieceIndex& piece) {
    if (const auto* typed = std::get_if<TypedVertices>(plan_.list.get()))
        return piece_in<Rational>(
            piece_of(scene_, *typed, typed_primitive(scene_, piece.primitive)), plan_);
    const ScreenPrimitive& part = parts_of(piece.primitive)[piece.part];
    return piece_of(scene_, list(), part);
}

Rational exact_depth_at(const Scene& scene, const Piece<Rational>& piece, std::uint16_t side, int x,
                        int y) {
    const bool larger_passes = depth_rule<Rational>(scene).larger_passes;
    if (piece.kind != PrimitiveKind::triangle) {
        const auto end = static_cast<std::uint16_t>((side + 1U) % piece.count);
        return line_points(piece, {side, end}, larger_passes, scene).depth_at({x, y});
    }
    const auto offset = sample_offset<Rational>(sample_of(scene.method), 1);
    const Triangle<Rational> triangle{piece.positions};
    TriangleDepth<Rational> depth(triangle.vertices, piece.depths, larger_passes);
    if (!finds_depths_along_edges(scene))
        return depth.plane(offset).on_row(y).at(x);
    const auto [left, right] = edges_of_row(triangle, y, offset, scene.canvas.down());
    const Rational height = offset.y_of(y);
    Rational left_x = offset.in_columns(left.x_at(height));
    Rational right_x = offset.in_columns(right.x_at(height));
    if (scene.method.depth_at == DepthAt::rounded_ends) {
        left_x = scalar_from<Rational>(first_pixel(left_x, span_rounding(scene.method)));
        right_x = scalar_from<Rational>(last_pixel(right_x, span_rounding(scene.method)));
    }
    return row_between<Rational>(left_x, depth.on_edge(left.name, height), right_x,
                                 depth.on_edge(right.name, height))
        .at(x);
}

std::optional<std::array<std::size_t, 2>> edge_of_depth(const Scene& scene, const Plan& plan,
                                                        const PieceIndex& index, int x, int y) {
    if (!finds_depths_along_edges(scene) ||
        scene.primitives[index.primitive].kind != PrimitiveKind::triangle)
        return std::nullopt;
    const bool has_rounded_ends = scene.method.depth_at == DepthAt::rounded_ends;
    const SpanRounding rounding = span_rounding(scene.method);
    std::optional<std::array<std::size_t, 2>> vertices;
    const auto find_in = [&]<typename AList>(const AList& list) {
        // Typed vertices have no depths.
        if constexpr (draws<Adaptive, AList> && !std::same_as<AList, TypedVertices>) {
            if (!is_whole(scene, list, index.primitive))
                return;
            const auto piece =
                piece_of(scene, list, {.primitive = index.primitive, .index = 0, .color = {}});
            const Triangle<Adaptive> triangle{piece_in<Adaptive>(piece, plan).positions};
            const auto offset = sample_offset<Adaptive>(sample_of(scene.method), plan.denominator);
            const auto [left, right] = edges_of_row(triangle, y, offset, scene.canvas.down());
            const Adaptive height = offset.y_of(y);
            const auto column = scalar_from<Adaptive>(x);
            const auto hold = [&](const Edge<Adaptive>& edge) {
                if (edge.is_horizontal)
                    return; // it has many depths in this row
                vertices = {piece.vertices[edge.name.from], piece.vertices[edge.name.to]};
                std::sort(vertices->begin(), vertices->end());
            };
            const Adaptive left_x = offset.in_columns(left.x_at(height));
            const Adaptive right_x = offset.in_columns(right.x_at(height));
            if (has_rounded_ends) {
                // A row of one pixel has the depth of its left end.
                const Index from = first_pixel(left_x, rounding);
                const Index to = last_pixel(right_x, rounding);
                if (x <= from || to <= from)
                    hold(left);
                else if (to <= x)
                    hold(right);
            } else if (column <= left_x) {
                hold(left);
            } else if (right_x <= column) {
                hold(right);
            }
        }
    };
    try {
        std::visit(find_in, *plan.list);
    } catch (const Undecided&) {
        return std::nullopt;
    }
    return vertices;
}

bool is_nearer(const Scene& scene, const Plan& plan, Exactness& exactness, std::uint32_t piece,
               std::optional<std::uint32_t> stored, int x, int row) {
    const int y = scene.canvas.y_of(row);
    const auto depth_of = [&](std::uint32_t number) {
        const PieceIndex& index = exactness.drawn[number];
        return exact_depth_at(scene, exactness.pieces.piece(index), index.side, x, y);
    };
    if (stored) {
        // Two faces have the same depth on the edge that they share.
        const auto edge_of = [&](std::uint32_t number) {
            return edge_of_depth(scene, plan, exactness.drawn[number], x, y);
        };
        const auto edge = edge_of(piece);
        if (edge && edge == edge_of(*stored))
            return false;
        return depth_of(piece) < depth_of(*stored);
    }
    const DepthRule<Rational> rule = depth_rule<Rational>(scene);
    if (!rule.cleared)
        return true;
    return depth_of(piece) < turned(*rule.cleared, rule.larger_passes);
}

Rational told_depth(const Scene& scene, Exactness& exactness, std::optional<std::uint32_t> piece,
                    int x, int row) {
    const DepthRule<Rational> rule = depth_rule<Rational>(scene);
    if (!piece)
        return *rule.cleared;
    const PieceIndex& index = exactness.drawn[*piece];
    return turned(
        exact_depth_at(scene, exactness.pieces.piece(index), index.side, x, scene.canvas.y_of(row)),
        rule.larger_passes);
}

} // namespace rastertrace
