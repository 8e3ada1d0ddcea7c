// SPDX-License-Identifier: MIT
#pragma once

// What is found out about faces: which way they are turned, how they are lit, and which lines are sides of none
// that is drawn. Compiled for float, double, Adaptive and Rational.

#include <rastertrace/core/draw/list/pieces.h>
#include <rastertrace/core/draw/scene/scene.h>
#include <rastertrace/core/numbers/vec.h>

#include <array>
#include <cstddef>
#include <functional>
#include <vector>

namespace rastertrace {

/// True if a primitive is a triangle whose face is tested or lit.
bool has_face(const Scene& scene, const ScenePrimitive& primitive);

/// The face of a primitive whose corners lie there in the world. Nothing is found out about one that has
/// none, but that it is a side of culled ones.
template <typename Scalar>
Face<Scalar> face_in(const Scene& scene, const ScreenList<Scalar>& list, std::size_t index,
                     const std::array<Vec<Scalar, 3>, 3>& world);

/// Which of the scene's lines are sides of faces none of which is drawn: `is_drawn(index)` tells whether a
/// triangle is. Empty if that does not matter to any.
std::vector<bool> culled_sides_of(const Scene& scene,
                                  const std::function<bool(std::size_t index)>& is_drawn);

/// False if a number of a face that would be told is none: a normal is a product of two lengths, and is
/// multiplied by a third one.
template <typename Scalar> bool is_finite(const Face<Scalar>& face);

} // namespace rastertrace
