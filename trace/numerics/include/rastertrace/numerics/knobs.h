// SPDX-License-Identifier: MIT
#pragma once

// Ways to save work that textbooks and old renderers know, each with a knob: how often an accumulated
// sum is begun anew, how many bits a number has, how often a pixel is divided by its depth. The
// report turns the knobs; nothing is drawn with these.
//
//     ReseededWalk<float> walk(edge, 1, 16);  // x from row to row, found anew in every 16th
//     walk.x_on_row(0);

#include <rastertrace/core/numbers/scalar.h>
#include <rastertrace/core/numbers/vec.h>
#include <rastertrace/core/raster/depth_interpolation.h>
#include <rastertrace/core/raster/edge.h>

#include <algorithm>
#include <array>
#include <concepts>
#include <cstddef>
#include <cstdint>
#include <limits>

namespace rastertrace {

/// An interval that never ends.
inline constexpr int without_end = std::numeric_limits<int>::max();

// x along an edge, from row to row.

/// x = (1 - t) x1 + t x2, t = (y - y1)/(y2 - y1). It reaches both ends, and divides in every row.
template <typename Scalar> class WeightedWalk {
public:
    WeightedWalk(const Vec<Scalar, 2>& from, const Vec<Scalar, 2>& to) : from_(from), to_(to) {}

    Scalar x_on_row(int y) const {
        const Scalar t = (scalar_from<Scalar>(y) - from_.y) / (to_.y - from_.y);
        return (scalar_from<Scalar>(1) - t) * from_.x + t * to_.x;
    }

private:
    Vec<Scalar, 2> from_;
    Vec<Scalar, 2> to_;
};

/// x += a, and in every `interval`th row x = x1 + a (y - y1) instead, which forgets what rounding has
/// gathered. 1 is the direct form, `never` the incremental one of EdgeWalk.
template <typename Scalar> class ReseededWalk {
public:
    ReseededWalk(const Edge<Scalar>& edge, int y_step, int interval)
        : edge_(edge), step_(y_step > 0 ? edge.dx_dy : Scalar(-edge.dx_dy)), interval_(interval) {}

    /// x on row `y`. After the first call, every call must ask for the next row.
    const Scalar& x_on_row(int y) {
        if (rows_left_ == 0) {
            x_ = edge_.x_at(scalar_from<Scalar>(y));
            rows_left_ = interval_;
        } else {
            x_ += step_;
        }
        --rows_left_;
        return x_;
    }

private:
    Edge<Scalar> edge_;
    Scalar step_;
    int interval_;
    int rows_left_ = 0;
    Scalar x_{};
};

/// An edge in whole numbers: coordinates in units of 1/unit pixel.
template <typename Integer> struct WholeEdge {
    Integer x1, y1, x2, y2;
    Integer unit; ///< to a pixel
};

/// x += a in fixed point, the way of processors without floating point: x and a have the bits of the
/// grid and no more, and the division that makes a drops what is below them (toward zero, as C++
/// does). a is always too small by up to 1 in its last place.
template <typename Integer> class FixedPointWalk {
public:
    /// The edge's unit must be 1/2^bits pixel.
    FixedPointWalk(const WholeEdge<Integer>& edge, int y_step, int first_y, int bits)
        : bits_(bits) {
        const Integer dy = edge.y2 - edge.y1;
        const Integer slope = dy == 0 ? Integer(0) : Integer((edge.x2 - edge.x1) * edge.unit / dy);
        step_ = y_step > 0 ? slope : Integer(-slope);
        // From the vertex to the first row, less the step that the first call takes.
        x_ = edge.x1 + (Integer(slope * (first_y * edge.unit - edge.y1)) >> bits) - step_;
    }

    /// Goes to the next row; the first call to the first one.
    void step() { x_ += step_; }
    /// x in units, and the pixel that it lies in.
    const Integer& x() const { return x_; }
    Index pixel() const { return static_cast<Index>(x_ >> bits_); }

private:
    int bits_;
    Integer x_;
    Integer step_;
};

/// x without rounding, in whole numbers: with coordinates n/D,
///
///     x = (x1 dy + dx (y D - y1)) / (D dy) = pixel + rest / (D dy)
///
/// and from row to row pixel and rest grow by those of D dx / (D dy): two additions, a comparison.
template <typename Integer> class QuotientWalk {
public:
    QuotientWalk(const WholeEdge<Integer>& edge, int y_step, int first_y) {
        const Integer dx = edge.x2 - edge.x1;
        const Integer dy = edge.y2 - edge.y1;
        const Integer sign = dy < 0 ? -1 : 1;
        whole_ = sign * edge.unit * dy;
        const auto split = [this](const Integer& above, Integer& quotient, Integer& rest) {
            quotient = floor_quotient<Integer>(above, whole_);
            rest = above - quotient * whole_;
        };
        split(sign * (edge.x1 * dy + dx * (first_y * edge.unit - edge.y1)), pixel_, rest_);
        split(sign * y_step * edge.unit * dx, pixel_step_, rest_step_);
    }

    /// The whole number at or left of x, on this row.
    const Integer& pixel() const { return pixel_; }
    /// What x has beyond it, in parts of whole().
    const Integer& rest() const { return rest_; }
    const Integer& whole() const { return whole_; }

    void step() {
        pixel_ += pixel_step_;
        rest_ += rest_step_;
        if (!(rest_ < whole_)) {
            rest_ -= whole_;
            pixel_ += 1;
        }
    }

private:
    Integer whole_; ///< D dy
    Integer pixel_, rest_;
    Integer pixel_step_, rest_step_;
};

// Depths.

/// The depths of a row, accumulated: d += slope, and every `interval`th pixel d = d0 + slope (x - x0)
/// instead.
template <typename Scalar> class ReseededDepths {
public:
    ReseededDepths(const DepthRow<Scalar>& row, int interval) : row_(row), interval_(interval) {}

    /// The depth at column `x`. After the first call, every call must ask for the next one.
    const Scalar& at(int x) {
        if (pixels_left_ == 0) {
            depth_ = row_.at(x);
            pixels_left_ = interval_;
        } else {
            depth_ += row_.slope;
        }
        --pixels_left_;
        return depth_;
    }

private:
    DepthRow<Scalar> row_;
    int interval_;
    int pixels_left_ = 0;
    Scalar depth_{};
};

/// The depths that a buffer of whole numbers tells apart: 2^bits codes from the nearest depth to the
/// farthest. Depths are turned (depth_buffer.h): a nearer one has the smaller code.
template <typename Scalar> class DepthCodes {
public:
    DepthCodes(const Scalar& nearest, const Scalar& farthest, int bits)
        : nearest_(nearest), last_((Index{1} << bits) - 1),
          codes_per_depth_(nearest < farthest
                               ? Scalar(scalar_from<Scalar>(last_) / (farthest - nearest))
                               : scalar_from<Scalar>(0)) {}

    /// The code nearest to a depth; what lies beyond either end has the code there.
    std::uint32_t code_of(const Scalar& depth) const {
        const Index code = floor_index(Scalar((depth - nearest_) * codes_per_depth_ + Scalar(0.5)));
        return static_cast<std::uint32_t>(std::clamp<Index>(code, 0, last_));
    }

    /// The depth that a code stands for.
    Scalar depth_of(std::uint32_t code) const {
        return codes_per_depth_ == scalar_from<Scalar>(0)
                   ? nearest_
                   : Scalar(nearest_ + scalar_from<Scalar>(code) / codes_per_depth_);
    }

private:
    Scalar nearest_;
    Index last_;
    Scalar codes_per_depth_;
};

// Colors in a perspective.

/// A quantity that is linear on the screen, from its values at the vertices of a triangle:
///
///     v = v1 + gx (x - x1) + gy (y - y1)
template <typename Scalar> struct ScreenPlane {
    Vec<Scalar, 2> origin;
    Scalar value;
    Scalar gradient_x, gradient_y;

    /// The triangle must have area; area2 is twice that, signed.
    ScreenPlane(const std::array<Vec<Scalar, 2>, 3>& at, const std::array<Scalar, 3>& values,
                const Scalar& area2)
        : origin(at[0]), value(values[0]) {
        const Scalar to_b = values[1] - values[0];
        const Scalar to_c = values[2] - values[0];
        gradient_x = (to_b * (at[2].y - at[0].y) - to_c * (at[1].y - at[0].y)) / area2;
        gradient_y = (to_c * (at[1].x - at[0].x) - to_b * (at[2].x - at[0].x)) / area2;
    }

    Scalar at(const Scalar& x, const Scalar& y) const {
        return value + gradient_x * (x - origin.x) + gradient_y * (y - origin.y);
    }
};

/// Attributes of a triangle in a perspective: s/w and 1/w are linear on the screen, s is their
/// quotient (Hoff and Hirota). The quotient is found in every `interval`th pixel of a row and at its
/// end, and between these s is taken to be linear, which it is not.
template <typename Scalar, std::size_t count> class PerspectiveRow {
public:
    using Values = std::array<Scalar, count>;

    /// Along the row of sample points at height `y`; samples lie `sample_offset` from integer points.
    PerspectiveRow(const std::array<ScreenPlane<Scalar>, count>& over_w,
                   const ScreenPlane<Scalar>& inverse_w, const Scalar& y,
                   const Scalar& sample_offset, int interval)
        : over_w_(over_w), inverse_w_(inverse_w), y_(y), sample_offset_(sample_offset),
          interval_(interval) {}

    /// Calls `visit(x, values)` with the pixels from x = `from` to x = `to`.
    template <typename Visit> void walk(int from, int to, Visit&& visit) const {
        Values left = divided_at(from);
        for (int x = from; x <= to;) {
            const int pixels = std::min(interval_, to - x);
            visit(x, left);
            if (pixels == 0)
                return;
            const Values right = divided_at(x + pixels);
            const Scalar share = scalar_from<Scalar>(1) / scalar_from<Scalar>(pixels);
            Values step;
            for (std::size_t i = 0; i < count; ++i)
                step[i] = (right[i] - left[i]) * share;
            for (int k = 1; k < pixels; ++k) {
                for (std::size_t i = 0; i < count; ++i)
                    left[i] += step[i];
                visit(x + k, left);
            }
            left = right;
            x += pixels;
        }
    }

private:
    Values divided_at(int column) const {
        const Scalar x = scalar_from<Scalar>(column) + sample_offset_;
        const Scalar w = scalar_from<Scalar>(1) / inverse_w_.at(x, y_);
        Values values;
        for (std::size_t i = 0; i < count; ++i)
            values[i] = over_w_[i].at(x, y_) * w;
        return values;
    }

    const std::array<ScreenPlane<Scalar>, count>& over_w_;
    const ScreenPlane<Scalar>& inverse_w_;
    Scalar y_;
    Scalar sample_offset_;
    int interval_;
};

} // namespace rastertrace
