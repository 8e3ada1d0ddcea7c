// SPDX-License-Identifier: MIT
#pragma once

// The triangle that the fills take.
//
//     Triangle<double> triangle{{{{2, 5}, {-4, -3}, {5, -3}}}};

#include <rastertrace/core/numbers/vec.h>

#include <array>

namespace rastertrace {

/// A triangle on the screen, its vertices in the scene's order. Any winding, any shape.
template <typename Scalar> struct Triangle { std::array<Vec<Scalar, 2>, 3> vertices; };

} // namespace rastertrace
