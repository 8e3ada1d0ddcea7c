// SPDX-License-Identifier: MIT
#pragma once

// The first difference between two traces with what each step says, and the steps around it.

#include "diff.h"
#include "diff_tally.h"
#include "trace_comparison.h"

namespace rastertrace {

/// Puts the first difference into `found`. Both texts are read again where it is.
void tell_first(TraceDiff& found, const TraceComparison& comparison, const TraceText& a,
                const TraceText& b);

} // namespace rastertrace
