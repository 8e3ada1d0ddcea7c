// SPDX-License-Identifier: MIT
#pragma once

// A scene drawn without a sink, with whichever number its plan has chosen. Compiled once for all that
// is measured.
//
//     const Image exact = drawn(scene, plan_for(scene));

#include <rastertrace/core/draw/plan/plan.h>
#include <rastertrace/core/draw/scene/scene.h>
#include <rastertrace/core/raster/image.h>

namespace rastertrace {

/// Draws a scene in which find_unfit has found nothing.
Image drawn(const Scene& scene, const Plan& plan);

} // namespace rastertrace
