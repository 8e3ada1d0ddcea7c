// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>

namespace rastertrace {

/// A pixel's column or row before it is known to lie on a canvas. Every value that a rounding rule
/// returns lies within +-`farthest_index`, and every value within it is a whole double and a whole
/// number to every JSON reader.
using Index = std::int64_t;

/// The largest index, 2^53 - 1: a coordinate farther out is given this index (it is off every
/// canvas).
inline constexpr Index farthest_index = 9'007'199'254'740'991;

} // namespace rastertrace
