// SPDX-License-Identifier: MIT
#pragma once

#include <rastertrace/core/draw/filtered/exactly.h>
#include <rastertrace/core/draw/list/pieces.h>
#include <rastertrace/core/draw/list/screen_list.h>
#include <rastertrace/core/draw/paint/sample_walk.h>
#include <rastertrace/core/numbers/scalar.h>
#include <rastertrace/core/numbers/vec.h>
#include <rastertrace/core/raster/depth.h>
#include <rastertrace/core/raster/image.h>
#include <rastertrace/core/raster/steps.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <span>

namespace rastertrace {

/// A point on the screen, and how deep it lies there.
template <typename Depth> struct DeepPoint {
    Vec<Depth, 2> at;
    Depth depth;
};

/// A corner of a piece, in the numbers of depths.
template <typename Scalar>
DeepPoint<DepthOf<Scalar>> corner_of(const Piece<Scalar>& piece, std::size_t corner) {
    const auto& at = piece.positions[corner];
    return {{depth_scalar(at.x), depth_scalar(at.y)}, piece.depths[corner]};
}

/// The corners of a triangle on the screen.
template <typename Depth> using DeepTriangle = std::array<DeepPoint<Depth>, 3>;

template <typename Scalar> DeepTriangle<DepthOf<Scalar>> corners_of(const Piece<Scalar>& triangle) {
    return {corner_of(triangle, 0), corner_of(triangle, 1), corner_of(triangle, 2)};
}

/// What pixels are drawn on and tested against, and where their samples lie.
template <typename Scalar, typename OfPixels = Scalar> struct Target {
    Image& image;
    SampleGrid<Scalar> grid;
    DepthBuffer<DepthOf<OfPixels>>* depth = nullptr; ///< if depths are tested
    Exactness* exactness = nullptr;                  ///< of `adaptive`

    /// The primitives in the order in which they are drawn. An owner in the depth buffer is one of them; of
    /// `adaptive`, one of those that it has drawn.
    std::span<const ScreenPrimitive> listed = {};

    /// The triangle that an owner stands for.
    std::function<DeepTriangle<DepthOf<OfPixels>>(std::uint32_t owner)> triangle_of = {};

    /// The scene's primitive that it is of.
    std::size_t primitive_index_of(std::uint32_t owner) const {
        return exactness ? exactness->drawn[owner].primitive : listed[owner].primitive;
    }

    /// The depths that follow are of another side of the same piece: for `adaptive`, one of its own.
    void begin_side(EdgeName side) const {
        if (!exactness || side.from == 0)
            return;
        PieceIndex piece = exactness->drawn.back();
        piece.side = side.from;
        depth->begin(static_cast<std::uint32_t>(exactness->drawn.size()));
        exactness->drawn.push_back(piece);
    }
};

} // namespace rastertrace
