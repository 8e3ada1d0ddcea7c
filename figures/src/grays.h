// SPDX-License-Identifier: MIT
#pragma once

// What the grays of a view say.

#include <rastertrace/core/raster/image.h>

#include <cstdint>

namespace rastertrace {

/// A gray on which black can be read in any theme: 0 is dark, 1 light.
Color gray(double share);

/// How light a pixel is that was written so often; beyond the most, all look alike.
inline constexpr std::uint32_t most_writes_told = 6;
double share_of_writes(std::uint32_t writes);

} // namespace rastertrace
