// SPDX-License-Identifier: MIT
// The colors of small bitmaps.

#pragma once

#include <rastertrace/figures/bitmap.h>

namespace rastertrace {

inline constexpr Color black{0, 0, 0};
inline constexpr Color white{255, 255, 255};
inline constexpr Color red{255, 0, 0};

} // namespace rastertrace
