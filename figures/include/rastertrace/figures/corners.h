// SPDX-License-Identifier: MIT
#pragma once

// Where the corners of a primitive lie, as its step in a trace tells them.

#include <rastertrace/trace/record/traced_steps.h>

#include <array>
#include <optional>
#include <vector>

namespace rastertrace {

/// A place in the picture, in pixels.
struct Point {
    double x;
    double y;
};

/// The corners, each as the nearest doubles; none if the step does not tell all of them.
std::vector<Point> corners_of(const PrimitiveStep& primitive);

/// What is linear on the screen, from its values at the first three corners: a, b, c of a x + b y + c. Nothing if these
/// have no area.
std::optional<std::array<double, 3>> plane_through(const std::vector<Point>& at,
                                                   const std::array<double, 3>& values);

} // namespace rastertrace
