// SPDX-License-Identifier: MIT
#pragma once

// The text of a scene for programs that have no reader of JSON, as `rastertrace fuzz` writes it. A line is a statement;
// # begins a comment. y points down from the top left corner.
//
//     canvas 8 8
//     tri A 0 0 0 8 0 0 0 8 0
//     line B 0 0 0 7.5 3 0
//     clip C -1 -1 0 1 1 -1 0 1 0 1 0 1

#include <rastertrace/trace/text/problem.h>

#include <string_view>

namespace rastertrace {

/// What such a text begins with.
inline constexpr std::string_view front_of_triangles = "canvas";

/// The scene that it describes, as a scene file. Throws a Problem.
Source scene_of_triangles(const Source& source);

} // namespace rastertrace
