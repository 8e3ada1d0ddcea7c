// SPDX-License-Identifier: MIT
#pragma once

// The empty sheet of a worked example, to be printed.

#include <rastertrace/figures/drawing.h>
#include <rastertrace/trace/record/trace.h>
#include <rastertrace/trace/text/input.h>

#include <string>
#include <string_view>

namespace rastertrace {

/// A page: the grid before the first step, and below it, in columns, what the scene gives, or, without one, the trace;
/// then what is asked. `exercise` is the ID of one, or empty.
Drawing sheet_page(const Trace& trace, const Source* scene, const std::string& exercise = {});

/// Throws a Problem if another file than this empty sheet is there: what was filled in would be lost.
void refuse_filled_sheet(const std::string& path, std::string_view empty);

} // namespace rastertrace
