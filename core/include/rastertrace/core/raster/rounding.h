// SPDX-License-Identifier: MIT
#pragma once

// Which pixels a span has: from the exact x of its two ends to its first and last pixel.
//
// A row of a triangle runs from left = -1/4 to right = 25/8. Which pixels is that?
//
//     rounding   first pixel     last pixel       here      what it means
//     floor      floor(left)     floor(right)     -1 .. 3   the textbook; may stick out on the left
//     nearest    nearest(left)   nearest(right)    0 .. 3   a tie (k + 1/2) goes as `ties` says
//     truncate   toward zero     toward zero       0 .. 3   a C++ cast to int; lopsided at 0
//     inside     ceil(left)      floor(right)      0 .. 3   only pixels that lie in the triangle
//
// Both ends are drawn. A span whose first pixel lies right of its last one is empty.

#include <rastertrace/core/numbers/scalar.h>
#include <rastertrace/core/raster/canvas.h>

#include <algorithm>

namespace rastertrace {

/// How the ends of a span become pixels; see the table above.
enum class Rounding { floor, nearest, truncate, inside };

/// Where `nearest` sends a number halfway between two whole numbers.
enum class Ties {
    start, ///< to the smaller one: -1/2 -> -1, 1/2 -> 0. Lines stay on the side that they come from,
           ///< as Bresenham's does (pixel_across)
    up,    ///< to the larger one: -1/2 -> 0, 1/2 -> 1
    away,  ///< away from zero: -1/2 -> -1, 1/2 -> 1
    even,  ///< to the even one: -1/2 -> 0, 1/2 -> 0
};

/// The rules that turn the ends of a span into pixels.
struct SpanRounding {
    Rounding rounding = Rounding::floor;
    Ties ties = Ties::up; ///< read only with Rounding::nearest
};

/// The whole number next to `x` in the direction of zero.
template <typename Scalar> Index truncate_index(const Scalar& x) {
    return x < scalar_from<Scalar>(0) ? ceil_index(x) : floor_index(x);
}

/// The whole number nearest to `x`; a tie goes where `ties` says.
template <typename Scalar> Index nearest_index(const Scalar& x, Ties ties) {
    // The whole numbers on both sides of x: one toward zero, one away from it.
    const bool is_negative = x < scalar_from<Scalar>(0);
    const Index inner = truncate_index(x);
    const Index outer = is_negative ? inner - 1 : inner + 1;
    if (inner <= -farthest_index || inner >= farthest_index)
        return inner;

    // How far x lies beyond the inner one, twice, against 1. The difference is exact in double too:
    // both numbers have the same sign and the inner one is the smaller.
    const Scalar difference = x - scalar_from<Scalar>(inner);
    const Scalar twice =
        is_negative ? Scalar(-difference - difference) : Scalar(difference + difference);
    const Scalar one = scalar_from<Scalar>(1);
    if (twice < one)
        return inner;
    if (one < twice)
        return outer;

    switch (ties) {
    case Ties::start:
        return std::min(inner, outer);
    case Ties::up:
        return std::max(inner, outer);
    case Ties::away:
        return outer;
    case Ties::even:
        break;
    }
    return inner % 2 == 0 ? inner : outer;
}

/// The first pixel of a span whose left end is at `left`.
template <typename Scalar> Index first_pixel(const Scalar& left, const SpanRounding& rule) {
    switch (rule.rounding) {
    case Rounding::floor:
        return floor_index(left);
    case Rounding::nearest:
        return nearest_index(left, rule.ties);
    case Rounding::truncate:
        return truncate_index(left);
    case Rounding::inside:
        break;
    }
    return ceil_index(left);
}

/// The last pixel of a span whose right end is at `right`. It differs from first_pixel only where
/// the span must stay inside.
template <typename Scalar> Index last_pixel(const Scalar& right, const SpanRounding& rule) {
    return rule.rounding == Rounding::inside ? floor_index(right) : first_pixel(right, rule);
}

} // namespace rastertrace
