// SPDX-License-Identifier: MIT
#pragma once

// The viewport of a scene: viewport.h of transform/ in exact numbers.

#include <rastertrace/core/numbers/number.h>
#include <rastertrace/core/numbers/rational.h>
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

/// What a viewport is a product of.
std::vector<MatrixFactor<Rational>> factors_of(const Viewport& viewport, const Canvas& canvas);

/// The product of the factors.
Matrix<Rational> viewport_matrix(const Viewport& viewport, const Canvas& canvas);

/// Half the canvas in canonical units (all of it without a viewport): `extent` is its width or height.
Rational half_extent(const Viewport& viewport, int extent);

} // namespace rastertrace
