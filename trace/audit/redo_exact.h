// SPDX-License-Identifier: MIT
#pragma once

// The decisions of scenes that are drawn with fractions, taken again: compiled apart, for they take long.

#include "redo.h"

namespace rastertrace {

/// Which steps are done again: of `adaptive`, primitives are told in doubles or in fractions. What is no primitive's
/// is done again with the fractions.
enum class StepsToRedo { all, in_doubles, in_fractions };

/// In exact numbers. Where a trace does not tell its scalar, only what is decided.
Redone redo_in_rationals(const Trace& trace, bool knows_all_numbers,
                         StepsToRedo steps = StepsToRedo::all);

/// `fixed`: the depths are doubles.
Redone redo_with_double_depths(const Trace& trace);

} // namespace rastertrace
