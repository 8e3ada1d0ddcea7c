// SPDX-License-Identifier: MIT
#pragma once

// Draws a scene: every primitive in the scene's order, by the method that the scene names.
//
//     const Image picture = draw(scene, plan_for(scene));
//     draw(scene, plan_for(scene), [](const PixelPlotted<>& step) { /* every pixel */ });

#include <rastertrace/core/draw/plan/plan.h>
#include <rastertrace/core/draw/scene/scene.h>
#include <rastertrace/core/draw/tell/listener.h>
#include <rastertrace/core/raster/image.h>

namespace rastertrace {

/// Draws a scene in which find_unfit has found nothing, and returns its picture. `listener` is told
/// every step that it takes; the picture is the same whoever listens. Who wants to know is told how
/// often intervals left a decision open.
Image draw(const Scene& scene, const Plan& plan, const Listener& listener = {},
           Fallbacks* fallbacks = nullptr);

} // namespace rastertrace
