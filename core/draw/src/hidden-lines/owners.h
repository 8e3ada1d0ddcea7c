// SPDX-License-Identifier: MIT
#pragma once

// What hidden lines need to know of the faces that have been drawn: which face a depth is of, and
// its corners.

#include <rastertrace/core/draw/list/pieces.h>
#include <rastertrace/core/numbers/vec.h>
#include <rastertrace/core/raster/canvas.h>
#include <rastertrace/core/raster/steps.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <functional>

namespace rastertrace {

/// A point on the screen, and its depth.
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

/// The owners of depths, by their numbers in DepthTests.
template <typename Depth> struct Owners {
    /// The index of the scene's primitive.
    std::function<std::size_t(std::uint32_t owner)> primitive_of = {};

    /// The triangle on the screen.
    std::function<DeepTriangle<Depth>(std::uint32_t owner)> triangle_of = {};
};

} // namespace rastertrace
