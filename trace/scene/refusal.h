// SPDX-License-Identifier: MIT
#pragma once

// Why a scene cannot be drawn by its method, in words.
//
//     if (const auto unfit = find_unfit(scene))
//         refusal_of(scene, *unfit).message;  // "expected coordinates up to ..., found ..."

#include <rastertrace/core/draw/plan/plan.h>
#include <rastertrace/core/draw/scene/scene.h>

#include <string>

namespace rastertrace {

/// What to tell the scene's author.
struct Refusal {
    std::string message; ///< "expected ..., found ..."
    std::string hint;    ///< may be empty
};

Refusal refusal_of(const Scene& scene, const Unfit& unfit);

} // namespace rastertrace
