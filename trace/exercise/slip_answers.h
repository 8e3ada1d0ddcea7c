// SPDX-License-Identifier: MIT
#pragma once

// What each slip makes of the numbers of a scene.

#include <rastertrace/trace/record/trace.h>
#include <rastertrace/trace/scene/distinguish.h>

namespace rastertrace {

/// For each of slips(), all the numbers that it makes of what can be worked out in a trace, as text; none where it cannot
/// be made.
Answers slip_answers_in(const Trace& trace);

} // namespace rastertrace
