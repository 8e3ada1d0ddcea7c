// SPDX-License-Identifier: MIT
#pragma once

// The formulas of shading.h in exact numbers.

#include <rastertrace/core/numbers/interval.h>
#include <rastertrace/core/numbers/irrational.h>
#include <rastertrace/core/numbers/rational.h>
#include <rastertrace/core/numbers/vec.h>
#include <rastertrace/core/raster/facing.h>

#include <optional>

namespace rastertrace {

/// The cosine of the angle between two exact vectors: the nearest double to its root. `nullopt` if
/// one of them has no length.
inline std::optional<double> cosine_between(const Vec<Rational, 3>& a, const Vec<Rational, 3>& b) {
    if (has_no_length<Rational>(a) || has_no_length<Rational>(b))
        return std::nullopt;
    const Rational product = dot(a, b);
    const Rational square = product * product / (dot(a, a) * dot(b, b));
    return sgn(product) * nearest_double(square_root(square));
}

inline std::optional<Interval> cosine_between(const Vec<Interval, 3>& a,
                                              const Vec<Interval, 3>& b) {
    if (has_no_length<Interval>(a) || has_no_length<Interval>(b))
        return std::nullopt;
    const Interval product = dot(a, b);
    const Interval root = square_root(product * product / (dot(a, a) * dot(b, b)));
    const Interval cosine = held_between(root, Interval(0), Interval(1));
    return product < Interval(0) ? -cosine : cosine;
}

} // namespace rastertrace
