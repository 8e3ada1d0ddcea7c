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

    /// What is said first counts. If nothing is said, what is nearer is smaller.
    void say_larger_is_nearer(bool is_larger) {
        if (!larger_is_nearer_)
            larger_is_nearer_ = is_larger;
    }
    bool knows_which_is_nearer() const { return larger_is_nearer_.has_value(); }

    /// The level of a gray, 0 to 255.
    int level_of(std::optional<double> depth) const;

private:
    std::optional<bool> larger_is_nearer_;
    std::optional<double> least_, largest_;
};

/// How light a pixel is that was written so often; beyond the most, all look alike.
inline constexpr std::uint32_t most_writes_told = 6;
double share_of_writes(std::uint32_t writes);

} // namespace rastertrace
