// SPDX-License-Identifier: MIT
#pragma once

// Barycentric coordinates: a point as a weighted mean of a triangle's vertices.
//
//     P = A + u AB + v AC = (1 - u - v) A + u B + v C
//
// Source: Sokolov, tinyrenderer, lesson 2, in the Chinese notes on it: (u, v, 1) is parallel to the
// cross product of (ABx, ACx, PAx) and (ABy, ACy, PAy). The product is a multiple of (u, v, 1): it
// has to be divided by its third part, which is twice the signed area.

#include <rastertrace/core/numbers/scalar.h>
#include <rastertrace/core/numbers/vec.h>
#include <rastertrace/core/raster/triangle.h>

#include <array>

namespace rastertrace {

/// A triangle made ready to find weights. Its area must not be 0 where weights are asked for.
template <typename Scalar> class Barycentric {
public:
    explicit Barycentric(const Triangle<Scalar>& triangle)
        : a_(triangle.vertices[0]), ab_(minus(triangle.vertices[1], a_)),
          ac_(minus(triangle.vertices[2], a_)), area2_(ab_.x * ac_.y - ac_.x * ab_.y) {}

    /// Twice the signed area, in square pixels; positive when A, B, C turn from +x toward +y.
    const Scalar& area2() const { return area2_; }

    /// The weights of A, B and C in `p`. They sum to 1; none is negative in the closed triangle.
    std::array<Scalar, 3> weights_at(const Vec<Scalar, 2>& p) const {
        const Vec<Scalar, 2> pa = minus(a_, p);
        const Scalar cross_x = ac_.x * pa.y - pa.x * ac_.y;
        const Scalar cross_y = pa.x * ab_.y - ab_.x * pa.y;
        const Scalar rest = area2_ - cross_x - cross_y;
        return {Scalar(rest / area2_), Scalar(cross_x / area2_), Scalar(cross_y / area2_)};
    }

private:
    static Vec<Scalar, 2> minus(const Vec<Scalar, 2>& p, const Vec<Scalar, 2>& q) {
        return {Scalar(p.x - q.x), Scalar(p.y - q.y)};
    }

    Vec<Scalar, 2> a_;
    Vec<Scalar, 2> ab_;
    Vec<Scalar, 2> ac_;
    Scalar area2_;
};

} // namespace rastertrace
