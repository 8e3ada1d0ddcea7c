// SPDX-License-Identifier: MIT
#pragma once

// Where the corners of a primitive lie, as its step in a trace tells them.

#include <rastertrace/trace/record/traced_steps.h>

#include <vector>

namespace rastertrace {

/// A place in the picture, in pixels.
struct Point {
    double x;
    double y;
};

/// The corners, each as the nearest doubles; none if the step does not tell all of them.
std::vector<Point> corners_of(const PrimitiveStep& primitive);

} // namespace rastertrace
