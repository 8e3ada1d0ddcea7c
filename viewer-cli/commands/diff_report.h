// SPDX-License-Identifier: MIT
#pragma once

// What two traces do differently, for a terminal and as JSON.
//
//     print(diff_in_color(diff_text(found), output_colors(ColorChoice::automatic)));

#include "app/json_text.h"
#include "frames/terminal_text.h"

#include <rastertrace/trace/compare/diff.h>

#include <optional>
#include <string>

namespace rastertrace {

/// Why a trace has the first pixel that differs, or has not. There has to be one. Throws a Problem.
std::string explanation_of_first_pixel(const TraceDiff& found, const Trace& trace);

/// "8 steps differ, 4 pixels differ"
std::string diff_summary(const TraceDiff& found);

/// What diff_text says, up to its table of kinds, and a line's end.
std::string without_kinds(const std::string& text);

/// What a step says, or that there is none.
std::string sentence_of(const std::optional<DiffStep>& step);

/// What diff_text says with colors: a in red, b in green, and the marks of pictures.
std::string diff_in_color(const std::string& text, ColorDepth colors);

/// docs/diff.md describes the keys.
JsonText diff_json(const TraceDiff& found);

} // namespace rastertrace
