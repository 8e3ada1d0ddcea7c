// SPDX-License-Identifier: MIT
#pragma once

// From canonical space to the screen: the scene's own coordinates of pixels (raster/canvas.h).
//
//     fit:              x = left + (x + 1) (W - 1)/2   y = 1: the top row, y = -1: the bottom row
//     pixels-per-unit:  x = x s                        y = y s, on a canvas with a centered origin
//
// Sources: fit, T4 (flip y, shift by 1, scale by (W - 1)/2 and (H - 1)/2); pixels-per-unit, T0:
// scaling.

#include <rastertrace/core/transform/matrix.h>

namespace rastertrace {

/// The pixels of a canvas, in the scene's coordinates.
struct ScreenBox {
    int left;     ///< the smallest x, and
    int lowest_y; ///< the smallest y of a pixel
    int width;    ///< in pixels
    int height;
    bool is_y_down;
};

/// The factors of `fit`: T4's flip, translation and scale, and a translation to the corner of a
/// canvas that does not begin at (0, 0). The last factor moves a point first.
template <typename Scalar> MatrixFactors<Scalar> fit_to(const ScreenBox& screen) {
    const Scalar left(screen.left);
    const Scalar lowest_y(screen.lowest_y);
    const Scalar half_width = Scalar(screen.width - 1) / 2;
    const Scalar half_height = Scalar(screen.height - 1) / 2;
    MatrixFactors<Scalar> factors;
    if (screen.left != 0 || screen.lowest_y != 0)
        factors.push_back({"translate", translation<Scalar>({left, lowest_y, 0})});
    factors.push_back({"scale", diagonal<Scalar>(half_width, half_height, 1, 1)});
    factors.push_back({"translate", translation<Scalar>({1, 1, 0})});
    if (screen.is_y_down)
        factors.push_back({"flip", diagonal<Scalar>(1, -1, 1, 1)});
    return factors;
}

} // namespace rastertrace
