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
//     half-open  ceil(left)      ceil(right) - 1   0 .. 3   inside, without the right end
//
// Both ends are drawn. A span whose first pixel lies right of its last one is empty. A line has no
// right end: it cannot be half-open.

#include <rastertrace/core/numbers/scalar.h>
#include <rastertrace/core/raster/canvas.h>
#include <rastertrace/core/raster/choices.h>

#include <algorithm>
#include <cstdint>

namespace rastertrace {

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
    case Ties::step: // only lines have it, and they say where they go (pixel_across)
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
    case Rounding::half_open:
        break;
    }
    return ceil_index(left);
}

/// The last pixel of a span whose right end is at `right`. It differs from first_pixel only where
/// the span must stay inside, or before its right end.
template <typename Scalar> Index last_pixel(const Scalar& right, const SpanRounding& rule) {
    switch (rule.rounding) {
    case Rounding::inside:
        return floor_index(right);
    case Rounding::half_open:
        return ceil_index(right) - 1;
    case Rounding::floor:
    case Rounding::nearest:
    case Rounding::truncate:
        break;
    }
    return first_pixel(right, rule);
}

/// The level of a channel, 0 to 255, that was mixed or lit. What lies outside of these is held
/// there.
template <typename Scalar> std::uint8_t level_of(const Scalar& channel, ColorRounding rounding) {
    const Index level = rounding == ColorRounding::nearest ? nearest_index(channel, Ties::up)
                                                           : floor_index(channel);
    return static_cast<std::uint8_t>(std::clamp<Index>(level, 0, 255));
}

} // namespace rastertrace
