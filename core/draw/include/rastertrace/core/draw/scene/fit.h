// SPDX-License-Identifier: MIT
#pragma once

// A camera that has everything in view. A sphere encloses the scene; the camera looks at its center
// along z, y up, from as near as all four sides of the view leave the sphere whole.
//
//      \      ___      /   A side at x = b z (z is the distance from the eye) leaves a sphere of
//       \   /     \   /    radius r around (cx, D) whole if
//        \ |   .   | /         (b D - cx) / sqrt(1 + b^2) >= r.
//         \ \ ___ / /      For the other side, x = a z, it is
//          \       /           (cx - a D) / sqrt(1 + a^2) >= r.
//           \     /        Both hold for some cx from
//             eye              D = r (sqrt(1 + a^2) + sqrt(1 + b^2)) / (b - a) on.
//
// All of it is worked out in fractions, and what is rounded is rounded to the safe side: the same
// camera on every machine.

#include <rastertrace/core/draw/scene/transforms.h>

namespace rastertrace {

/// A box with sides along the axes.
struct Box {
    Vec<Rational, 3> low;
    Vec<Rational, 3> high;
};

/// Extends the box to a point; without a box, it is this point alone.
void include(std::optional<Box>& box, const Vec<Rational, 3>& point);

/// The values from `low` to `high`.
struct Extent {
    Rational low;
    Rational high;

    bool operator==(const Extent&) const = default;
};

/// What a projection shows on a canvas, in camera space. x and y are multiples of the distance from
/// the eye in a perspective, else lengths.
struct ViewVolume {
    bool is_perspective = true;
    Extent x;
    Extent y;
    Rational near = 0;                ///< distances from the eye
    std::optional<Rational> far = {}; ///< none: infinitely far
};

ViewVolume view_volume(const Projection& projection, const Viewport& viewport,
                       const Canvas& canvas);

/// What both volumes show.
ViewVolume intersection(const ViewVolume& a, const ViewVolume& b);

/// The middle of a box, rounded to a hundredth of its size or less, so that it has few digits.
Vec<Rational, 3> center_of(const Box& box);

/// Why no camera can be fitted.
enum class FitFault {
    one_place, ///< everything is at one point
    size,      ///< it is smaller than smallest_fit, or reaches beyond largest_fit
    no_view,   ///< the volume is empty
};

/// The least radius, and the largest distance from the origin, that a camera is fitted to.
inline constexpr double smallest_fit = 1e-300;
inline constexpr double largest_fit = 1e300;

/// The vertical field of view, in degrees, of a camera that is fitted to a scene without a
/// projection.
inline constexpr int fitted_fov_y = 40;

/// A camera, and the distances of the near and the far plane that it needs.
struct FittedCamera {
    Camera camera;
    Number near;
    Number far;
};

/// The camera that sees all of the sphere around `center` whose radius has this square, if the far
/// plane lies behind it. An orthographic projection shows as much from everywhere: the sphere is
/// put in the middle of its box.
std::variant<FittedCamera, FitFault> fitted_camera(const Vec<Rational, 3>& center,
                                                   const Rational& square, const ViewVolume& volume,
                                                   ViewAxis axis);

} // namespace rastertrace
