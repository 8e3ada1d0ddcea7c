// SPDX-License-Identifier: MIT
#pragma once

// The formulas of shading.h in filtered doubles.

#include <rastertrace/core/numbers/adaptive.h>
#include <rastertrace/core/numbers/vec.h>
#include <rastertrace/core/raster/facing.h>
#include <rastertrace/core/raster/shading.h>

#include <algorithm>
#include <cmath>
#include <optional>

namespace rastertrace {

/// The cosine of the angle between two vectors. `nullopt` if one of them has no length.
inline std::optional<Adaptive> cosine_between(const Vec<Adaptive, 3>& a,
                                              const Vec<Adaptive, 3>& b) {
    if (has_no_length<Adaptive>(a) || has_no_length<Adaptive>(b))
        return std::nullopt;
    const Adaptive product = dot(a, b);
    const Adaptive square = product * product / (dot(a, a) * dot(b, b));
    // Each of the roots is rounded once.
    const double low =
        std::sqrt(std::max(0.0, square.value() - square.error())) / Adaptive::widening;
    const double high =
        std::min(1.0, std::sqrt(square.value() + square.error()) * Adaptive::widening);
    const double middle = (low + high) / 2;
    return Adaptive(product < Adaptive(0) ? -middle : middle,
                    (high - low) / 2 * Adaptive::widening);
}

/// A lit color whose intensity has an error. Throws Undecided if the error decides about a level.
inline Color lit(Color color, Adaptive intensity, ColorRounding rounding) {
    const Color darkest =
        lit(color, std::max(0.0, intensity.value() - intensity.error()), rounding);
    if (lit(color, std::min(1.0, intensity.value() + intensity.error()), rounding) != darkest)
        Adaptive::leave_open(intensity.value(), intensity.error());
    return darkest;
}

} // namespace rastertrace
