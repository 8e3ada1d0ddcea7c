// SPDX-License-Identifier: MIT
#pragma once

// The formulas of shading.h in exact numbers.

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

} // namespace rastertrace
