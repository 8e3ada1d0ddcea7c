// SPDX-License-Identifier: MIT
#pragma once

// What the grays of a view say.

#include <rastertrace/core/raster/image.h>

#include <cstdint>
#include <optional>

namespace rastertrace {

/// A gray on which black can be read in any theme: 0 is dark, 1 light.
Color gray(double share);

/// Depths as grays: the nearest of those that are included is the lightest.
class DepthGrays {
public:
    void include(double depth);

    /// Said once, if it is known; else, what is nearer is smaller.
    void say_larger_is_nearer(bool is_larger) { larger_is_nearer_ = is_larger; }

    /// The level of a gray, 0 to 255.
    int level_of(std::optional<double> depth) const;

private:
    bool larger_is_nearer_ = false;
    std::optional<double> least_, largest_;
};

/// How light a pixel is that was written so often; beyond the most, all look alike.
inline constexpr std::uint32_t most_writes_told = 6;
double share_of_writes(std::uint32_t writes);

} // namespace rastertrace
