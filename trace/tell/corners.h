// SPDX-License-Identifier: MIT
#pragma once

// Where the corners of a primitive lie, as its step in a trace tells them: in pixels.

#include "place.h"

#include <rastertrace/trace/record/traced_steps.h>

#include <array>
#include <optional>

namespace rastertrace {

/// The corners, each as the nearest doubles; none if the step does not tell all of them.
Path corners_of(const PrimitiveStep& primitive);

/// What is linear on the screen, from its values at the first three corners: a, b, c of a x + b y + c. Nothing if these
/// have no area.
std::optional<std::array<double, 3>> plane_through(const Path& at,
                                                   const std::array<double, 3>& values);

} // namespace rastertrace
