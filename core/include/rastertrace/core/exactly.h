// SPDX-License-Identifier: MIT
#pragma once

// What `adaptive` falls back on where the errors of doubles leave a decision open: the same
// primitives with exact numbers, worked out one by one when they are asked for.
//
//     ExactPieces exact(scene, plan);
//     exact.placed({.primitive = 3, .part = 0});  // its corners as fractions

#include <rastertrace/core/adaptive.h>
#include <rastertrace/core/adaptive_color.h>
#include <rastertrace/core/adaptive_depth.h>
#include <rastertrace/core/barycentric.h>
#include <rastertrace/core/depth.h>
#include <rastertrace/core/edge.h>
#include <rastertrace/core/fill_scanline.h>
#include <rastertrace/core/geometry.h>
#include <rastertrace/core/paint.h>
#include <rastertrace/core/pieces.h>
#include <rastertrace/core/placed.h>
#include <rastertrace/core/plan.h>
#include <rastertrace/core/scalar.h>
#include <rastertrace/core/scene.h>
#include <rastertrace/core/sink.h>
#include <rastertrace/core/steps.h>
#include <rastertrace/core/triangle.h>
#include <rastertrace/core/vec.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <compare>
#include <concepts>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <map>
#include <optional>
#include <utility>
#include <variant>
#include <vector>

namespace rastertrace {

/// A piece: which part of which primitive.
struct PieceNumber {
    std::size_t primitive = 0;
    std::size_t part = 0;

    friend auto operator<=>(const PieceNumber&, const PieceNumber&) = default;
};

/// The pieces of a scene in exact numbers. Only what is asked for is worked out.
class ExactPieces {
public:
    ExactPieces(const Scene& scene, const Plan& plan) : scene_(scene), plan_(plan) {}

    /// Visits the pieces of a primitive.
    template <typename Sink, typename Visit>
    void visit(std::size_t number, Sink&& sink, Visit&& visit) {
        const bool mixes_colors = scene_.mixes_colors();
        if (std::holds_alternative<TypedGeometry>(plan_.geometry))
            visit_pieces(scene_, TypedGeometry{}, number, mixes_colors, sink, visit);
        else
            visit_pieces(scene_, geometry_with(number), number, mixes_colors, sink, visit);
    }

    /// The corners of a piece, as they are drawn, without their names.
    const PlacedPrimitive<Rational>& placed(const PieceNumber& piece) {
        const auto known = placed_.find(piece);
        if (known != placed_.end())
            return known->second;
        PieceNumber next{piece.primitive, 0};
        visit(piece.primitive, NullSink{}, [&](const auto& one) {
            auto exact = rastertrace::placed<Rational>(one, plan_);
            exact.names = {}; // those of parts end with the visit
            placed_.emplace(next, std::move(exact));
            ++next.part;
        });
        return placed_.at(piece);
    }

private:
    /// The geometry of the scene, in which a primitive's vertices have their places.
    const Geometry<Rational>& geometry_with(std::size_t number) {
        if (const auto* whole = std::get_if<Geometry<Rational>>(&plan_.geometry))
            return *whole;
        if (!geometry_) {
            geometry_ = empty_geometry<Rational>(scene_);
            geometry_->transforms.divides =
                std::get<Geometry<Adaptive>>(plan_.geometry).transforms.divides;
        }
        for (const std::size_t place : scene_.primitives[number].corners()) {
            if (geometry_->is_used[place])
                continue;
            geometry_->is_used[place] = true;
            place_in_clip_space(scene_, model_of(scene_, *geometry_, place), place, *geometry_);
            place_on_screen(place, *geometry_);
        }
        return *geometry_;
    }

    const Scene& scene_;
    const Plan& plan_;
    std::optional<Geometry<Rational>> geometry_;
    std::map<PieceNumber, PlacedPrimitive<Rational>> placed_;
};

/// The edges that a row lies between.
template <typename Scalar> struct EdgesOfRow {
    Edge<Scalar> left;
    Edge<Scalar> right;
};
template <typename Scalar>
EdgesOfRow<Scalar> edges_of_row(const Triangle<Scalar>& triangle, int y, int down) {
    const JoinedEdges<Scalar> edges = joined_edges(triangle, down);
    const bool is_lower = first_lower_y(edges, down) * down <= Index{y} * down;
    const Edge<Scalar>& short_edge = is_lower ? edges.lower : edges.upper;
    return edges.long_edge_is_left ? EdgesOfRow<Scalar>{edges.long_edge, short_edge}
                                   : EdgesOfRow<Scalar>{short_edge, edges.long_edge};
}

/// True if the fill that the scene names finds depths by rows, then across; else by weights.
inline bool finds_depths_by_rows(const Scene& scene) {
    return scene.method.fill != Fill::top_left && scene.method.fill != Fill::barycentric;
}

/// The turned depth of a triangle in the pixel at (x, y), as the fill that the scene names finds it.
inline Rational exact_depth_at(const Scene& scene, const PlacedPrimitive<Rational>& primitive,
                               int x, int y) {
    const Triangle<Rational> triangle{primitive.positions};
    DepthBuffer<Rational> nothing({}, depth_rule<Rational>(scene));
    TriangleDepth<Rational> depth(triangle, primitive.depths, nothing);
    if (!finds_depths_by_rows(scene)) {
        depth.prepare(scalar_from<Rational>(sample_offset_of(scene.method)));
        return depth.on_row(y).at(x);
    }
    const auto [left, right] = edges_of_row(triangle, y, scene.canvas.down());
    const Rational height = y;
    return TriangleDepth<Rational>::between(left.x_at(height), depth.on_edge(left.name, height),
                                            right.x_at(height), depth.on_edge(right.name, height))
        .at(x);
}

/// The two vertices of the edge that a pixel has its depth from: it lies at an end of its row or beyond.
/// Nothing if it does not, or if that cannot be told in doubles; so it is never told of a triangle
/// without area, whose rows have no width, and two depths: doubles do not know that it has none.
inline std::optional<std::array<std::size_t, 2>>
edge_of_depth(const Scene& scene, const Plan& plan, const PieceNumber& number, int x, int y) {
    if (!finds_depths_by_rows(scene))
        return std::nullopt;
    std::optional<std::array<std::size_t, 2>> vertices;
    const auto look_at = [&]<typename Coordinate>(const Piece<Coordinate>& piece) {
        if constexpr (draws<Adaptive, Coordinate>) {
            if (piece.is_part)
                return;
            const Triangle<Adaptive> triangle{placed<Adaptive>(piece, plan).positions};
            const auto [left, right] = edges_of_row(triangle, y, scene.canvas.down());
            const auto height = scalar_from<Adaptive>(y);
            const auto column = scalar_from<Adaptive>(x);
            const auto hold = [&](const Edge<Adaptive>& edge) {
                if (edge.is_horizontal)
                    return; // it has many depths in this row
                vertices = {piece.vertices[edge.name.from], piece.vertices[edge.name.to]};
                std::sort(vertices->begin(), vertices->end());
            };
            if (column <= left.x_at(height))
                hold(left);
            else if (right.x_at(height) <= column)
                hold(right);
        }
    };
    try {
        std::visit(
            [&](const auto& geometry) {
                visit_pieces(scene, geometry, number.primitive, false, NullSink{}, look_at);
            },
            plan.geometry);
    } catch (const Undecided&) {
        return std::nullopt;
    }
    return vertices;
}

/// How often `adaptive` could not decide with doubles.
struct Fallbacks {
    std::uint64_t primitives = 0; ///< or parts of one: drawn with exact numbers, from some row on
    std::uint64_t depths = 0;     ///< tests
    std::uint64_t colors = 0;     ///< of pixels
};

/// What `adaptive` needs to decide exactly what its numbers leave open.
struct Exactness {
    ExactPieces pieces;
    Rational sample_offset;
    std::vector<PieceNumber> drawn = {}; ///< the pieces so far; the last one is being drawn
    std::optional<MixedColors<Rational>> colors = {}; ///< of that, if one has been asked for
    Fallbacks fallbacks = {};
};

/// Whether a piece is nearer in a pixel than what is stored there, in exact numbers.
inline bool is_nearer(const Scene& scene, const Plan& plan, Exactness& exactness,
                      std::uint32_t piece, std::optional<std::uint32_t> stored, int x, int row) {
    const int y = scene.canvas.y_of(row);
    const auto depth_of = [&](std::uint32_t number) {
        return exact_depth_at(scene, exactness.pieces.placed(exactness.drawn[number]), x, y);
    };
    if (stored) {
        // Two faces that meet in an edge seen from aside have one depth there: no need to work it out.
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
    return depth_of(piece) < (rule.larger_passes ? Rational(-*rule.cleared) : *rule.cleared);
}

/// The exact depth of a piece in a pixel, as it is told; of a clear cell if there is no piece.
inline Rational told_depth(const Scene& scene, Exactness& exactness,
                           std::optional<std::uint32_t> piece, int x, int row) {
    const DepthRule<Rational> rule = depth_rule<Rational>(scene);
    if (!piece)
        return *rule.cleared;
    const Rational turned = exact_depth_at(scene, exactness.pieces.placed(exactness.drawn[*piece]),
                                           x, scene.canvas.y_of(row));
    return rule.larger_passes ? Rational(-turned) : turned;
}

/// Colors that are mixed with errors, pixel by pixel, and exactly where an error reaches over half a
/// level.
template <typename Scalar>
MixedColors<Adaptive> mixed_colors(const PlacedPrimitive<Scalar>& primitive, ColorStage stage,
                                   Exactness& exactness) {
    Triangle<Adaptive> triangle;
    std::array<Adaptive, 3> inverse_w;
    for (std::size_t i = 0; i < 3; ++i) {
        const auto& [x, y] = primitive.positions[i];
        triangle.vertices[i] = {with_error(x), with_error(y)};
        inverse_w[i] = with_error(primitive.inverse_w[i]);
    }
    exactness.colors.reset();
    const auto exact_color = [&exactness, stage](Pixel pixel) {
        ++exactness.fallbacks.colors;
        auto& colors = exactness.colors;
        if (!colors) {
            const auto& exact = exactness.pieces.placed(exactness.drawn.back());
            colors = {exact.colors, Barycentric<Rational>({exact.positions}),
                      exactness.sample_offset, exact.inverse_w};
        }
        return stage == ColorStage::perspective ? colors->at<true>(pixel)
                                                : colors->at<false>(pixel);
    };
    return {primitive.colors, triangle, with_error(exactness.sample_offset), inverse_w,
            exact_color};
}

/// False if a number of a step has left the doubles: it can only be told exactly.
template <typename Step> bool is_told_by_doubles(const Step&) {
    return true;
}
inline bool is_finite(std::same_as<Adaptive> auto... numbers) {
    return (std::isfinite(numbers.value()) && ...);
}
inline bool is_finite(const Vec<Adaptive, 3>& at) {
    return is_finite(at.x, at.y, at.z);
}
inline bool is_told_by_doubles(const VertexPlaced<Adaptive>& step) {
    return std::all_of(step.at.begin(), step.at.end(), [](Adaptive x) { return is_finite(x); });
}
inline bool is_told_by_doubles(const FaceTested<Adaptive>& step) {
    return is_finite(step.normal) && is_finite(step.view) && is_finite(step.dot);
}
inline bool is_told_by_doubles(const FaceLit<Adaptive>& step) {
    return is_finite(step.normal) && is_finite(step.light) && is_finite(step.dot);
}
inline bool is_told_by_doubles(const EdgeSetUp<Adaptive>& step) {
    return is_finite(step.dx_dy);
}
inline bool is_told_by_doubles(const EdgeFunctionSetUp<Adaptive>& step) {
    return is_finite(step.a, step.b, step.c);
}
inline bool is_told_by_doubles(const ScanlineSpanned<Adaptive>& step) {
    return is_finite(step.left, step.right) && (!step.left_depth || is_finite(*step.left_depth)) &&
           (!step.right_depth || is_finite(*step.right_depth));
}
inline bool is_told_by_doubles(const LineSampled<Adaptive>& step) {
    return is_finite(step.value);
}
inline bool is_told_by_doubles(const SampleTested<Adaptive>& step) {
    return is_finite(step.weights[0], step.weights[1], step.weights[2]);
}

/// Passes steps on, and can be told to pass over as many as it has had: those that come again when
/// what stopped halfway is done once more from its beginning. A step that doubles cannot tell is left
/// open like a decision that they cannot take.
template <typename Sink> class ResumedSink {
public:
    explicit ResumedSink(Sink& sink) : sink_(sink) {}

    template <typename Step> void operator()(const Step& step) {
        if (to_pass_over_ > 0) {
            --to_pass_over_;
            return;
        }
        if (!is_told_by_doubles(step)) {
            constexpr double infinity = std::numeric_limits<double>::infinity();
            Adaptive::leave_open(infinity, infinity);
        }
        ++passed_on_;
        sink_(step);
    }

    template <typename Step> bool takes() const { return rastertrace::takes<Step>(sink_); }

    void pass_over_what_came() { to_pass_over_ = passed_on_; }

private:
    Sink& sink_;
    std::uint64_t passed_on_ = 0;
    std::uint64_t to_pass_over_ = 0;
};

/// There is nothing to pass on.
template <> class ResumedSink<NullSink> : public NullSink {
public:
    explicit ResumedSink(NullSink&) {}
    void pass_over_what_came() {}
};

} // namespace rastertrace
