// SPDX-License-Identifier: MIT
#pragma once

// The decisions of scenes that are drawn with fractions, taken again: compiled apart, for they take long.

#include "redo.h"

namespace rastertrace {

/// In exact numbers. Of `adaptive`, whose numbers are rounded where nothing hangs on them, only what they decide.
Redone redo_in_rationals(const Trace& trace, bool knows_all_numbers);

/// `fixed`: the depths are doubles.
Redone redo_with_double_depths(const Trace& trace);

} // namespace rastertrace
