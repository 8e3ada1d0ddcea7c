// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

namespace rastertrace {

/// A place on a sheet, in its units, or on the screen, in pixels.
struct Place {
    double x = 0;
    double y = 0;

    friend bool operator==(const Place&, const Place&) = default;
};

/// A line from place to place.
using Path = std::vector<Place>;

} // namespace rastertrace
