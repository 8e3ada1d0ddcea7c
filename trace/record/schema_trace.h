// SPDX-License-Identifier: MIT
#pragma once

#include <rastertrace/trace/text/schema_parts.h>

namespace rastertrace {

/// The schema of a trace, made from the tables of its reader: trace_keys.h and step_kind.h.
Json trace_schema();

} // namespace rastertrace
