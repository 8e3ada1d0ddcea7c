// SPDX-License-Identifier: MIT
#pragma once

// The scene of a page that draws by itself.
//
//     page.scene = scene_of_page(source, command.method, trace.canvas);

#include <rastertrace/figures/page.h>

#include <rastertrace/core/raster/canvas.h>
#include <rastertrace/trace/text/method_names.h>
#include <rastertrace/trace/text/problem.h>

namespace rastertrace {

/// The scene with the method that it was drawn by; its text is "" if the page cannot draw it: it is not JSON, names files,
/// or numbers vary. A small one in the plane can be moved, and has the canvas that it was drawn on: it has at most
/// most_primitives_to_move primitives, and a canvas no larger than those with answers about each pixel.
PageScene scene_of_page(const Source& source, const MethodOverrides& method, const Canvas& canvas);

} // namespace rastertrace
