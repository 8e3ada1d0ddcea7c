// SPDX-License-Identifier: MIT
#pragma once

// The text formats that two courses hand out with their rasterizers, read as scenes of ours: that of UIUC CS418
// (`png`, `xyzw`, `rgb`, `tri`, and later `position`, `color`, `drawArraysTriangles`), and that of UCR CS130 (`size`,
// `vertex_shader`, `vertex_data`, `v`, `render`); and the text that `rastertrace fuzz` writes for programs that have no
// reader of JSON: `canvas 8 8`, `tri A 0 0 0 8 0 0 0 8 0`, `line B 0 0 0 7.5 3 0`, and in clip space
// `clip C -1 -1 0 1 1 -1 0 1 0 1 0 1`; y points down from the top left corner. A line is a statement; # begins a
// comment.
//
//     png 20 30 mine.png          size 320 240
//     xyzw 0 0.5 0 1              vertex_shader color
//     rgb 255 0 0                 fragment_shader gouraud
//     xyzw 1 -0.5 0 2             vertex_data ffffff
//     tri 1 2 -1                  v 0.5 0.25 0.5 1 0 0
//                                 render triangle
//
//     if (is_foreign_scene(source))
//         scene = scene_of_foreign(source);  // JSON, or the Problem and its place

#include <rastertrace/trace/text/problem.h>

namespace rastertrace {

/// The scene that such a text, an SVG (svg_text.h) or an OBJ file (obj_file.h), seen by a camera that fits, describes, as a scene file, by the convention of its course. A
/// statement that is not of the format is refused, and so is one that has no counterpart here: a texture, a matrix.
Result<Source> scene_of_foreign(const Source& source);

} // namespace rastertrace
