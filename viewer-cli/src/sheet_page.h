// SPDX-License-Identifier: MIT
#pragma once

// The empty sheet of a worked example, to be printed.

#include <rastertrace/figures/drawing.h>
#include <rastertrace/trace/record/trace.h>

namespace rastertrace {

/// A page: the grid before the first step, and below it, in columns, what is asked.
Drawing sheet_page(const Trace& trace);

} // namespace rastertrace
