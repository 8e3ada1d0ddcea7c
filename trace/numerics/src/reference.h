// SPDX-License-Identifier: MIT
#pragma once

// What a picture must be: as the model draws it, in fractions, by the definition of each method
// (model.h). It shares no line with the fills that it judges. Bresenham's lines that are too long for it
// are done here, pixel by pixel of the canvas.

#include <rastertrace/core/draw/scene/scene.h>
#include <rastertrace/core/numbers/conversion.h>
#include <rastertrace/core/raster/image.h>

#include <array>
#include <cstddef>
#include <vector>

namespace rastertrace {

/// A point in the scene's coordinates.
struct ExactPoint {
    Rational x;
    Rational y;
};

/// Which pixels of a canvas something covers: row-major, top row first.
using CoveredPixels = std::vector<bool>;

/// The pixels of a triangle by a method's fill (scanline, two-halves, barycentric or top-left), its
/// rounding and sample.
CoveredPixels covered_by(const std::array<ExactPoint, 3>& triangle, const Method& method,
                         const Canvas& canvas);

/// The samples, at the centers of pixels, of a convex polygon by the top-left rule.
CoveredPixels covered_by_polygon(const std::vector<ExactPoint>& polygon, const Canvas& canvas);

/// The picture of a scene. Lines beyond the model's reach are drawn over all else.
Colors reference_picture(const Scene& scene);

/// The scene with every vertex at the nearest multiple of 1/parts pixel, a half up.
Scene snapped_to_grid(Scene scene, int parts = 256);

/// The vertices of a primitive.
std::array<ExactPoint, 3> exact_corners(const Scene& scene, std::size_t primitive);

/// Twice the signed area.
Rational exact_area2(const std::array<ExactPoint, 3>& triangle);

/// A value that is linear on the screen: a x + b y + c.
struct ExactPlane {
    Rational a;
    Rational b;
    Rational c;

    Rational at(const ExactPoint& p) const { return a * p.x + b * p.y + c; }
};

/// The plane that has these values in the corners of a triangle, which must have area.
ExactPlane plane_through(const std::array<ExactPoint, 3>& triangle,
                         const std::array<Rational, 3>& values);

} // namespace rastertrace
