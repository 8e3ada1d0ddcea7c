// SPDX-License-Identifier: MIT
#pragma once

// The first difference between two traces with what each step says, and the steps around it.

#include "diff.h"
#include "trace_comparison.h"

namespace rastertrace {

/// Puts the first difference into `found`.
void tell_first(TraceDiff& found, const TraceComparison& comparison, const Trace& a,
                const Trace& b);

} // namespace rastertrace
