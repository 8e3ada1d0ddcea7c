// SPDX-License-Identifier: MIT
#pragma once

// Lines and polygons cut to what a panel shows.

#include <rastertrace/figures/drawing.h>

#include <functional>
#include <optional>
#include <utility>

namespace rastertrace {

/// The part of a line inside of a rectangle, borders included: Liang and Barsky 1984. None if there is none, or a
/// place is not finite.
std::optional<std::pair<Place, Place>> clipped(Place from, Place to, const Rectangle& frame);

/// The part of a convex polygon where a linear function of places is not negative: Sutherland and Hodgman 1974.
Path clipped(const Path& polygon, const std::function<double(Place)>& function);

/// The corners of a rectangle, in a circle.
Path corners_of(const Rectangle& frame);

} // namespace rastertrace
