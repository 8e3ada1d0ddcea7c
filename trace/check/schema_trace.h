// SPDX-License-Identifier: MIT
#pragma once

#include <string>

namespace rastertrace {

/// The schema of a trace, made from the tables of its reader: trace_keys.h and step_kind.h.
std::string trace_schema();

} // namespace rastertrace
