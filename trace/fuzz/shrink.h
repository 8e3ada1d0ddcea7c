// SPDX-License-Identifier: MIT
#pragma once

// The smallest scene that still fails: fewer primitives and vertices, a smaller canvas, simpler numbers.
//
//     const Shrunk small = shrunk(scene, [](const FuzzScene& one) { return differs(one); }, 2000);

#include "fuzz_scene.h"

#include <cstddef>
#include <functional>

namespace rastertrace {

struct Shrunk {
    FuzzScene scene{};
    std::size_t tries = 0;
};

/// Tries simpler scenes, one change at a time, as long as one of them still fails, or for so many tries. `scene` has to
/// fail. What is found depends on nothing but what `fails` says.
Shrunk shrunk(FuzzScene scene, const std::function<bool(const FuzzScene&)>& fails,
              std::size_t most_tries);

} // namespace rastertrace
