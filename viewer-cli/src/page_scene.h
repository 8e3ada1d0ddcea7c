// SPDX-License-Identifier: MIT
#pragma once

// The scene of a page whose vertices can be moved: a small one, typed in pixels.
//
//     page.scene = scene_to_move(source, command.method, trace.canvas);

#include <rastertrace/core/raster/canvas.h>
#include <rastertrace/trace/text/method_names.h>
#include <rastertrace/trace/text/problem.h>

#include <string>

namespace rastertrace {

/// The scene with the method that it was drawn by and the canvas that it was drawn on, so that it is drawn alike
/// wherever its vertices are; "" if its vertices cannot be moved: it is in space, numbers vary, it has more than
/// most_primitives_to_move primitives, or a canvas larger than those with answers about each pixel.
std::string scene_to_move(const Source& source, const MethodOverrides& method,
                          const Canvas& canvas);

} // namespace rastertrace
