// SPDX-License-Identifier: MIT
#pragma once

// What two traces do differently, for a pull request, a CI server and a terminal.
//
//     print(diff_markdown(found, "pictures"));

#include "terminal_text.h"

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

/// A summary, and what diff_text says folded away. With a folder for pictures, `a.png`, `b.png` and `difference.png` are
/// written there, of the part that differs, and shown side by side. Throws a Problem.
std::string diff_markdown(const TraceDiff& found, const std::string& picture_folder);

/// One test case, which fails if they differ.
std::string diff_junit(const TraceDiff& found);

/// What diff_text says with colors: a in red, b in green, and the marks of pictures.
std::string diff_in_color(const std::string& text, ColorDepth colors);

} // namespace rastertrace
