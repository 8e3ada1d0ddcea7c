// SPDX-License-Identifier: MIT
#pragma once

// The exact fallback of filtered doubles: the same primitives in exact numbers, computed when they
// are needed.
//
//     ExactPieces exact(scene, plan);
//     exact.piece({.primitive = 3, .part = 0});  // its corners as fractions

#include <rastertrace/core/draw/filtered/filtered.h>
#include <rastertrace/core/draw/list/geometry.h>
#include <rastertrace/core/draw/list/pieces.h>
#include <rastertrace/core/draw/paint/piece_in.h>
#include <rastertrace/core/draw/plan/plan.h>
#include <rastertrace/core/draw/scene/scene.h>
#include <rastertrace/core/draw/tell/listener.h>
#include <rastertrace/core/numbers/adaptive.h>
#include <rastertrace/core/numbers/conversion.h>
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
#include <span>
#include <vector>

namespace rastertrace {

/// A part of a primitive, or a side of an outline.
struct PieceIndex {
    std::uint32_t primitive = 0;
    std::uint32_t part = 0;
    std::optional<std::uint32_t> listed = {}; ///< its index in the plan's list, if it is there
    std::uint16_t side = 0;                   ///< of an outline: the index of its first corner
};

/// The list of what is drawn, in exact numbers. A primitive is added when it is needed.
class ExactPieces {
public:
    ExactPieces(const Scene& scene, const Plan& plan) : scene_(scene), plan_(plan) {}

    /// The parts of a primitive of a scene with a pipeline. A copy: drawing it may add to the list.
    std::vector<ScreenPrimitive> of(std::size_t primitive);

    /// The list that holds these parts.
    const ScreenList<Rational>& list() const { return geometry_->list; }

    /// The corners of a piece, as they are drawn.
    Piece<Rational> piece(const PieceIndex& piece);

private:
    /// The parts of a primitive in the list, which is added if it is not there yet.
    std::span<const ScreenPrimitive> parts_of(std::size_t primitive);

    /// A part of the list, to before `end`.
    struct Range {
        std::size_t begin = 0;
        std::size_t end = 0;
    };

    const Scene& scene_;
    const Plan& plan_;
    std::optional<Geometry<Rational>> geometry_; ///< only the vertices in use are on the screen
    std::map<std::size_t, Range> ranges_;        ///< of the primitives in the list
};

/// The turned depth of a piece (of an outline: of a side) in the pixel at (x, y), by the scene's
/// method.
Rational exact_depth_at(const Scene& scene, const Piece<Rational>& piece, std::uint16_t side, int x,
                        int y);

/// The two vertices of the edge whose depth a triangle's pixel has, because it lies at an end of
/// its row or beyond. Returns nullopt if the pixel lies inside its row, or if that is undecided;
/// also for a triangle without area, whose rows have two depths and no width.
std::optional<std::array<std::size_t, 2>> edge_of_depth(const Scene& scene, const Plan& plan,
                                                        const PieceIndex& index, int x, int y);

/// The state of the exact fallback during a drawing.
struct Exactness {
    ExactPieces pieces;
    SampleOffset<Rational> offset;      ///< of the samples of triangles
    std::vector<PieceIndex> drawn = {}; ///< the pieces so far; the last one is being drawn
    std::optional<MixedColors<Rational>> colors = {}; ///< of the last piece, if a pixel needed them
    Fallbacks fallbacks = {};
};

/// Returns whether a piece is nearer in a pixel than the stored piece, or than a clear cell,
/// exactly.
bool is_nearer(const Scene& scene, const Plan& plan, Exactness& exactness, std::uint32_t piece,
               std::optional<std::uint32_t> stored, int x, int row);

/// The exact depth of a piece in a pixel, not turned; of a clear cell if there is no piece.
Rational told_depth(const Scene& scene, Exactness& exactness, std::optional<std::uint32_t> piece,
                    int x, int row);

/// The colors of a triangle in filtered doubles, with exact numbers for the levels that are
/// undecided.
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
            colors = {exact.colors, Barycentric<Rational>({exact.positions}), exactness.offset,
                      exact.inverse_w, rounding};
        }
        return stage == ColorStage::perspective ? colors->at<true>(pixel)
                                                : colors->at<false>(pixel);
    };
    return {primitive.colors,
            triangle,
            {with_error(exactness.offset.x()), with_error(exactness.offset.y())},
            inverse_w,
            rounding,
            exact_color};
}

} // namespace rastertrace
