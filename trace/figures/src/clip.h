// SPDX-License-Identifier: MIT
#pragma once

// Shapes cut to a rectangle: to what a panel shows, or to what of a sheet TeX has numbers for.
//
//     clipped({-1e6, 10}, {1e6, 10}, {{0, 0}, 40, 20});  // {0, 10} and {40, 10}

#include <rastertrace/figures/drawing.h>

#include <functional>
#include <optional>
#include <utility>
#include <vector>

namespace rastertrace {

/// The part of a line inside of a rectangle, borders included: border by border, after Sutherland and Hodgman 1974.
/// Nothing if there is none, or if the line is longer than doubles can tell.
std::optional<std::pair<Place, Place>> clipped(Place from, Place to, const Rectangle& frame);

/// The parts of a line through many places, one after the other.
std::vector<Path> clipped_pieces(const Path& path, const Rectangle& frame);

/// The part of a convex polygon where a linear function of places is not negative: Sutherland and Hodgman 1974.
Path clipped(const Path& polygon, const std::function<double(Place)>& function);

/// The same for the part in a rectangle; empty if there is none.
Path clipped(const Path& polygon, const Rectangle& frame);

/// The part of a rectangle, whose width and height may be negative; nothing if it has no area.
std::optional<Rectangle> clipped(const Rectangle& rectangle, const Rectangle& frame);

/// The corners of a rectangle, in a circle.
Path corners_of(const Rectangle& frame);

} // namespace rastertrace
