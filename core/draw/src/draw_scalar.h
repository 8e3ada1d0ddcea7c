// SPDX-License-Identifier: MIT
#pragma once

#include <rastertrace/core/draw/draw.h>

namespace rastertrace {

/// Draws a scene whose plan has chosen Scalar. Each is compiled in a file of its own:
/// draw_in_*.cpp.
template <typename Scalar>
Image draw_in(const Scene& scene, const Plan& plan, const Listener& listener, Fallbacks* fallbacks);

/// In doubles where intervals decide everything, else in fractions.
template <>
Image draw_in<Interval>(const Scene& scene, const Plan& plan, const Listener& listener,
                        Fallbacks* fallbacks);

} // namespace rastertrace
