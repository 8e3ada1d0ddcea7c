// SPDX-License-Identifier: MIT
#pragma once

// From canonical space to the screen: the scene's own coordinates of pixels (raster/canvas.h). Where -1..1 goes:
//
//     centers:          from the first pixel to the last     x = left + (x + 1) (W - 1)/2
//     edges:            from one edge of the canvas to the   x = left + (x + 1) W/2
//                       other: pixel i is i to i + 1
//     edges-half:       the same where pixel i is            x = left + (x + 1) W/2 - 1/2
//                       i - 1/2 to i + 1/2
//     pixels-per-unit:  x = x s, y = y s, on a canvas with a centered origin
//
// y = 1 is at the top of the picture, or, if it is turned, at the bottom. z = -1 goes to `near` of a depth range, z = 1
// to `far`: z = near + (z + 1) (far - near)/2. Without a range z stays.
//
// Sources: centers, T4 (flip y, shift by 1, scale by (W - 1)/2 and (H - 1)/2); edges, Segal and Akeley, The OpenGL
// Graphics System, "Controlling the Viewport"; pixels-per-unit, T0: scaling.

#include <rastertrace/core/transform/matrix.h>

#include <optional>

namespace rastertrace {

/// Where -1 and 1 lie on the pixels of a canvas.
enum class PixelRange { centers, edges, edges_half };

/// The pixels of a canvas, in the scene's coordinates.
struct ScreenBox {
    int left;     ///< the smallest x, and
    int lowest_y; ///< the smallest y of a pixel
    int width;    ///< in pixels
    int height;
    bool is_turned; ///< y grows to the other side in canonical space
};

/// The depths that the lowest z, -1 or 0, and z = 1 become.
template <typename Scalar> struct DepthRange {
    Scalar near;
    Scalar far;
    int lowest_z = -1;
};

/// The factors of a viewport: T4's flip, translation and scale, and a translation to the corner of a
/// canvas that does not begin at (0, 0). The last factor moves a point first.
template <typename Scalar>
MatrixFactors<Scalar> viewport_factors(const ScreenBox& screen, PixelRange range,
                                       const std::optional<DepthRange<Scalar>>& depths) {
    const Scalar half = Scalar(1) / 2;
    const Scalar before = range == PixelRange::edges_half ? half : Scalar(0);
    const Scalar left = Scalar(screen.left) - before;
    const Scalar lowest_y = Scalar(screen.lowest_y) - before;
    const int less = range == PixelRange::centers ? 1 : 0;
    const Scalar half_width = Scalar(screen.width - less) / 2;
    const Scalar half_height = Scalar(screen.height - less) / 2;
    const Scalar near = depths ? depths->near : Scalar(0);
    const int lowest_z = depths ? depths->lowest_z : 0;
    const Scalar depth_scale =
        depths ? Scalar((depths->far - depths->near) / (1 - lowest_z)) : Scalar(1);
    MatrixFactors<Scalar> factors;
    if (left != 0 || lowest_y != 0 || near != 0)
        factors.push_back({"translate", translation<Scalar>({left, lowest_y, near})});
    factors.push_back({"scale", diagonal<Scalar>(half_width, half_height, depth_scale, 1)});
    factors.push_back({"translate", translation<Scalar>({1, 1, -lowest_z})});
    if (screen.is_turned)
        factors.push_back({"flip", diagonal<Scalar>(1, -1, 1, 1)});
    return factors;
}

} // namespace rastertrace
