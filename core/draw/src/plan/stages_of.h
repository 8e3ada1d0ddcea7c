// SPDX-License-Identifier: MIT
#pragma once

// Which stages a scene needs: a survey of its primitives, and what follows from it. stages.h has
// the table.
//
//     Stages stages = stages_of(scene, screen_list_for(scene), sizeof(double));

#include <rastertrace/core/draw/list/screen_list.h>
#include <rastertrace/core/draw/plan/stages.h>
#include <rastertrace/core/draw/scene/scene.h>

#include <cstddef>

namespace rastertrace {

/// Decides about every stage. `depth_size` is that of an element of the depth buffer, in bytes.
Stages stages_of(const Scene& scene, const AnyScreenList& list, std::size_t depth_size);

} // namespace rastertrace
