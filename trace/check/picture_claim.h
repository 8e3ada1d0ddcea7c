// SPDX-License-Identifier: MIT
#pragma once

// A picture that somebody drew by hand, held against the final picture of a trace.

#include "check.h"
#include "step_index.h"

namespace rastertrace {

/// Compares it with what `decided` has drawn; a picture of only the rows and columns that are drawn will do.
/// Throws a Problem if it has another size.
CheckedClaim check_picture(const Claim& claim, const Claims& claims, const StepIndex& decided);

} // namespace rastertrace
