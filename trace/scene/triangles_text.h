// SPDX-License-Identifier: MIT
#pragma once

// The text that `rastertrace fuzz` writes for programs that have no reader of JSON, read as a scene: a statement on each
// line, y points down from the top left corner, # begins a comment, but for the color #rrggbb of a primitive.
//
//     canvas 8 8
//     tri A 0 0 0 8 0 0 0 8 0 #e6194b
//     line B 0 0 0 7.5 3 0
//     clip C -1 -1 0 1 1 -1 0 1 0 1 0 1   # in clip space

#include <rastertrace/trace/text/problem.h>

namespace rastertrace {

/// The scene that such a text describes, as a scene file. Any other statement is refused.
Result<Source> scene_of_triangles(const Source& source);

} // namespace rastertrace
