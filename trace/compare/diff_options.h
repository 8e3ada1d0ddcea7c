// SPDX-License-Identifier: MIT
#pragma once

// The names in the options of a comparison: kinds of steps and their fields.
//
//     check_names(options, a, b);  // throws a Problem

#include "diff.h"

namespace rastertrace {

/// Throws a Problem if an option names a kind or a field that no trace can have, or that neither of these two has.
void check_names(const DiffOptions& options, const Trace& a, const Trace& b);

} // namespace rastertrace
