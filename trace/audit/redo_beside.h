// SPDX-License-Identifier: MIT
#pragma once

// Decisions of a primitive that cannot be drawn again, because the trace does not tell its scalar, a rule or its corners:
// each taken again from the numbers beside it, exactly.

#include "redo_findings.h"

namespace rastertrace {

/// The primitive that begins with step `first`, and its steps up to `last`.
void redo_beside(const Trace& trace, std::size_t first, std::size_t last, Findings& findings);

} // namespace rastertrace
