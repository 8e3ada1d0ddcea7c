// SPDX-License-Identifier: MIT
#pragma once

// From canonical space to the screen: the scene's own coordinates of pixels (raster/canvas.h).
//
//     fit:              x = left + (x + 1) (W - 1)/2     y = 1 is the top row, y = -1 the bottom row
//     pixels-per-unit:  x = x s                          y = y s, on a canvas with the origin in its
//                                                        center
//
// Sources: fit, T4 (flip y, shift by 1, scale by (W - 1)/2 and (H - 1)/2); pixels-per-unit, T0: scaling.

#include <rastertrace/core/numbers/scalar.h>
#include <rastertrace/core/transform/matrix.h>

#include <vector>

namespace rastertrace {

/// The pixels of a canvas, in the scene's coordinates.
struct ScreenBox {
    int left;     ///< the smallest x, and
    int lowest_y; ///< the smallest y of a pixel
    int width;    ///< in pixels
    int height;
    bool is_y_down;
};

/// What `fit` is the product of: T4's flip, translation and scale, and the way to the corner of a canvas
/// that does not begin at (0, 0). The last one moves a point first.
template <typename Scalar> std::vector<MatrixFactor<Scalar>> fit_to(const ScreenBox& screen) {
    const Scalar zero = scalar_from<Scalar>(0);
    const Scalar one = scalar_from<Scalar>(1);
    const Scalar two = scalar_from<Scalar>(2);
    std::vector<MatrixFactor<Scalar>> factors;
    if (screen.left != 0 || screen.lowest_y != 0)
        factors.push_back(
            {"translate", translation<Scalar>({scalar_from<Scalar>(screen.left),
                                               scalar_from<Scalar>(screen.lowest_y), zero})});
    factors.push_back(
        {"scale",
         diagonal<Scalar>(Scalar(scalar_from<Scalar>(screen.width - 1) / two),
                          Scalar(scalar_from<Scalar>(screen.height - 1) / two), one, one)});
    factors.push_back({"translate", translation<Scalar>({one, one, zero})});
    if (screen.is_y_down)
        factors.push_back({"flip", diagonal<Scalar>(one, Scalar(-one), one, one)});
    return factors;
}

} // namespace rastertrace
