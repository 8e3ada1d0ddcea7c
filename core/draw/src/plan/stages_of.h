// SPDX-License-Identifier: MIT
#pragma once

// Which stages a scene needs: a survey of its primitives, and what follows from it. stages.h has the table.
//
//     Stages stages = stages_of(scene, screen_list_of(scene, geometry), sizeof(double));

#include <rastertrace/core/draw/list/screen_list.h>
#include <rastertrace/core/draw/plan/stages.h>
#include <rastertrace/core/draw/scene/scene.h>

#include <cstddef>

namespace rastertrace {

/// Decides about every stage, from vertices as typed or from a list. `depth_size` is that of a number of the
/// depth buffer, in bytes.
template <typename AList>
Stages stages_of(const Scene& scene, const AList& list, std::size_t depth_size);

} // namespace rastertrace
