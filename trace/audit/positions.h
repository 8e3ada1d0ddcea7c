// SPDX-License-Identifier: MIT
#pragma once

// Places on the screen as the steps of a trace give them, exactly: numbers stand for the doubles, or floats, that a
// rasterizer has stored.
//
//     const auto at = positions_in(trace.step(1).as<PrimitiveStep>(), trace);

#include "screen_point.h"

#include <rastertrace/trace/record/trace.h>
#include <rastertrace/trace/record/traced_steps.h>

#include <array>
#include <optional>

namespace rastertrace {

/// The corners that a primitive's step gives, if they are three pairs of numbers and given exactly.
std::optional<std::array<ScreenPoint, 3>> positions_in(const PrimitiveStep& step,
                                                       const Trace& header);

} // namespace rastertrace
