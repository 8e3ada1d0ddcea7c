// SPDX-License-Identifier: MIT
#pragma once

// What a trace amounts to, as `rastertrace stats` prints it.

#include "app/json_text.h"

#include <rastertrace/trace/audit/stats.h>
#include <rastertrace/trace/record/trace.h>

#include <string>

namespace rastertrace {

/// For people: a line for each primitive or mesh, and for each finding, with the first pixels of each.
std::string stats_text(const Trace& trace, const Stats& stats);

/// The same as JSON, with everything one by one.
JsonText stats_json(const Trace& trace, const Stats& stats);

} // namespace rastertrace
