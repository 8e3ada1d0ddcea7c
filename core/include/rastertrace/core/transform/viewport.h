// SPDX-License-Identifier: MIT
#pragma once

// From canonical space to the screen: the scene's own coordinates of pixels (canvas.h).
//
//     fit:              x = left + (x + 1) (W - 1)/2     y = 1 is the top row, y = -1 the bottom row
//     pixels-per-unit:  x = x s                          y = y s, on a canvas with the origin in its
//                                                        center
//
// Sources: fit, T4 (flip y, shift by 1, scale by (W - 1)/2 and (H - 1)/2); pixels-per-unit, T0.

#include <rastertrace/core/numbers/number.h>
#include <rastertrace/core/numbers/scalar.h>
#include <rastertrace/core/raster/canvas.h>
#include <rastertrace/core/transform/matrix.h>

#include <vector>

namespace rastertrace {

enum class ViewportType {
    none, ///< canonical coordinates are pixels
    fit,
    pixels_per_unit,
};

struct Viewport {
    ViewportType type = ViewportType::none;
    Number pixels_per_unit = 1;
};

/// Where screen vertices go before anything is drawn.
enum class Snap {
    none,
    floor,
    truncate, ///< toward zero
    nearest,  ///< a half goes as `ties` says, up if it says nothing
};

/// What a viewport is a product of: T4's scale, translation and flip of `fit`, or the scale of
/// `pixels-per-unit`.
std::vector<MatrixFactor<Rational>> factors_of(const Viewport& viewport, const Canvas& canvas);

/// The product of the factors.
Matrix<Rational> viewport_matrix(const Viewport& viewport, const Canvas& canvas);

/// Half the canvas in canonical units (all of it without a viewport): `extent` is its width or height.
Rational half_extent(const Viewport& viewport, int extent);

} // namespace rastertrace
