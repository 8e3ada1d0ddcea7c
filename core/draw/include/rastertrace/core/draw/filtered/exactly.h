// SPDX-License-Identifier: MIT
#pragma once

// What `adaptive` falls back on where the errors of doubles leave a decision open: the same
// primitives with exact numbers, worked out one by one when they are asked for.
//
//     ExactPieces exact(scene, plan);
//     exact.piece({.primitive = 3, .part = 0});  // its corners as fractions

#include <rastertrace/core/draw/filtered/adaptive_color.h>
#include <rastertrace/core/draw/filtered/adaptive_depth.h>
#include <rastertrace/core/draw/filtered/adaptive_edge.h>
#include <rastertrace/core/draw/list/geometry.h>
#include <rastertrace/core/draw/list/pieces.h>
#include <rastertrace/core/draw/paint/piece_in.h>
#include <rastertrace/core/draw/plan/plan.h>
#include <rastertrace/core/draw/scene/scene.h>
#include <rastertrace/core/draw/tell/listener.h>
#include <rastertrace/core/numbers/adaptive.h>
#include <rastertrace/core/numbers/conversion.h>
#include <rastertrace/core/numbers/quantity.h>
#include <rastertrace/core/numbers/vec.h>
#include <rastertrace/core/raster/barycentric.h>
#include <rastertrace/core/raster/depth_interpolation.h>
#include <rastertrace/core/raster/mixed_colors.h>
#include <rastertrace/core/raster/steps.h>
#include <rastertrace/core/raster/triangle.h>

#include <array>
#include <compare>
#include <cstddef>
#include <cstdint>
#include <map>
#include <optional>
#include <vector>

namespace rastertrace {

/// A piece: which part of which primitive, and which side of an outline.
struct PieceIndex {
    std::size_t primitive = 0;
    std::size_t part = 0;
    std::uint8_t side = 0; ///< of an outline: the corner that it begins at
    std::optional<std::uint32_t> listed =
        {}; ///< its place in the plan's list, if doubles could tell it
};

/// The list of what is drawn, in exact numbers. Only what is asked for is worked out.
class ExactPieces {
public:
    ExactPieces(const Scene& scene, const Plan& plan) : scene_(scene), plan_(plan) {}

    /// What is drawn of a primitive of a scene with a pipeline. A copy: drawing it may add to the list.
    std::vector<ScreenPrimitive> of(std::size_t primitive);

    /// The list that has these.
    const ScreenList<Rational>& list() const { return geometry_->list; }

    /// The corners of a piece, as they are drawn.
    Piece<Rational> piece(const PieceIndex& piece);

private:
    /// A part of the list, to before `end`.
    struct Range {
        std::size_t begin = 0;
        std::size_t end = 0;
    };

    /// Where the list has a primitive; adds what is not there yet.
    Range range_of(std::size_t primitive);

    const Scene& scene_;
    const Plan& plan_;
    std::optional<Geometry<Rational>> geometry_; ///< in which some vertices have their places
    std::map<std::size_t, Range> ranges_;        ///< of primitives
};

/// The turned depth of a piece in the pixel at (x, y), as the fill or the line that the scene names finds
/// it; of an outline, that of a side.
Rational exact_depth_at(const Scene& scene, const Piece<Rational>& piece, std::uint8_t side, int x,
                        int y);

/// The two vertices of the edge that gives a triangle's pixel its depth, which lies at an end of its row or
/// beyond. `nullopt` if the pixel lies inside its row, or if doubles cannot decide that; so also of a
/// triangle without area, whose rows have no width, and two depths.
std::optional<std::array<std::size_t, 2>> edge_of_depth(const Scene& scene, const Plan& plan,
                                                        const PieceIndex& index, int x, int y);

/// What `adaptive` needs to decide exactly what its numbers leave open.
struct Exactness {
    ExactPieces pieces;
    Rational sample_offset;
    std::vector<PieceIndex> drawn = {}; ///< the pieces so far; the last one is being drawn
    std::optional<MixedColors<Rational>> colors = {}; ///< of that, if one has been asked for
    Fallbacks fallbacks = {};
};

/// Whether a piece is nearer in a pixel than what is stored there, in exact numbers.
bool is_nearer(const Scene& scene, const Plan& plan, Exactness& exactness, std::uint32_t piece,
               std::optional<std::uint32_t> stored, int x, int row);

/// The exact depth of a piece in a pixel, as it is told; of a clear cell if there is no piece.
Rational told_depth(const Scene& scene, Exactness& exactness, std::optional<std::uint32_t> piece,
                    int x, int row);

/// Colors that are mixed with errors, pixel by pixel, and exactly where an error reaches over half a
/// level.
template <typename Scalar>
MixedColors<Adaptive> mixed_colors(const Piece<Scalar>& primitive, ColorStage stage,
                                   ColorRounding rounding, Exactness& exactness) {
    Triangle<Adaptive> triangle;
    std::array<Adaptive, 3> inverse_w;
    for (std::size_t i = 0; i < 3; ++i) {
        const auto& [x, y] = primitive.positions[i];
        triangle.vertices[i] = {with_error(x), with_error(y)};
        inverse_w[i] = with_error(primitive.inverse_w[i]);
    }
    exactness.colors.reset();
    const auto exact_color = [&exactness, stage, rounding](Pixel pixel) {
        ++exactness.fallbacks.colors;
        auto& colors = exactness.colors;
        if (!colors) {
            const auto exact = exactness.pieces.piece(exactness.drawn.back());
            colors = {exact.colors, Barycentric<Rational>({exact.positions}),
                      exactness.sample_offset, exact.inverse_w, rounding};
        }
        return stage == ColorStage::perspective ? colors->at<true>(pixel)
                                                : colors->at<false>(pixel);
    };
    return {primitive.colors, triangle, with_error(exactness.sample_offset),
            inverse_w,        rounding, exact_color};
}

/// False if a number of a step has left the doubles: it can only be told exactly.
template <typename Step> bool is_told_by_doubles(const Step&) {
    return true;
}
bool is_told_by_doubles(const VertexPlaced<Quantity>& step);
bool is_told_by_doubles(const FaceTested<Quantity>& step);
bool is_told_by_doubles(const FaceLit<Quantity>& step);
bool is_told_by_doubles(const EdgeSetUp<Quantity>& step);
bool is_told_by_doubles(const EdgeFunctionSetUp<Quantity>& step);
bool is_told_by_doubles(const ScanlineSpanned<Quantity>& step);
bool is_told_by_doubles(const LineSampled<Quantity>& step);
bool is_told_by_doubles(const SampleTested<Quantity>& step);

} // namespace rastertrace
