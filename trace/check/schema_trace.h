// SPDX-License-Identifier: MIT
#pragma once

#include <rastertrace/trace/text/json_key.h>

#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace rastertrace {

/// The schema of a trace, made from the tables of its reader: trace_keys.h and step_kind.h.
std::string trace_schema();

/// Some kinds of step, and when their steps fire.
std::vector<JsonWord> step_kind_words(std::span<const std::string_view> names);

} // namespace rastertrace
