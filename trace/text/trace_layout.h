// SPDX-License-Identifier: MIT
#pragma once

// What the text of a file tells before any step is read: whether it is a trace, and how its lines are laid out.
//
//     layout_of(first_line) == LineLayout::lines;  // JSON Lines

#include "problem.h"

#include <cstdint>
#include <string_view>

namespace rastertrace {

/// How the lines behind a header are laid out.
enum class LineLayout : std::uint8_t {
    document, ///< `]` closes the steps
    lines,    ///< JSON Lines: a line of its own has the end record
    other,    ///< not a step a line
};

/// The layout that the first line of a trace tells.
LineLayout layout_of(std::string_view first_line);

/// True for a line with the end record of JSON Lines.
bool is_end_line(std::string_view line);

/// True if a source holds a trace rather than a scene: an object with the key "rastertrace".
bool is_trace(const Source& source);

/// The first word of a text behind blanks and lines that begin with #; "" of JSON.
std::string_view first_statement(const Source& source);

/// True of a statement that an OBJ file may begin with.
bool begins_obj(std::string_view statement);

/// True of a scene that is not JSON: the text of `fuzz` begins with `canvas` (trace/scene/triangles_text.h), and OBJ with
/// one of its statements (obj_file.h).
bool is_foreign_scene(const Source& source);

} // namespace rastertrace
