// SPDX-License-Identifier: MIT
#pragma once

// What a team has agreed on for its goldens: rastertrace-rules.json, in the folder of the golden.
//
//     {"ignore": ["header", "pixel.color"], "tolerance": ["depth=4ulp"], "key": {"tile": ["tx", "ty"]},
//      "method": "our-method.json"}

#include "diff.h"

#include <rastertrace/trace/text/input.h>
#include <rastertrace/trace/text/method_names.h>

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace rastertrace {

inline constexpr std::string_view rules_name = "rastertrace-rules.json";

struct DiffRules {
    DiffOptions options{};
    MethodOverrides method{}; ///< for scenes; options of the command override it
};

/// The rules in the folder of a golden; nothing if there are none. Throws a Problem.
std::optional<DiffRules> rules_beside(const std::string& golden, const InputLimits& limits);

/// Throws a Problem for what are no rules.
DiffRules read_rules(const std::string& path, const InputLimits& limits);

/// Goldens that are accepted besides `NAME.golden.jsonl`: `NAME.gcc.golden.jsonl`, in the same folder, by name.
std::vector<std::string> other_goldens(const std::string& golden);

/// Rules, and what is asked for besides, which counts where both are about one number.
DiffOptions joined_options(DiffOptions rules, const DiffOptions& asked);

/// Reads `tile=tx,ty`: the fields that a step of a kind of one's own is found by. Throws a Problem.
void add_step_key(DiffOptions& options, const std::string& text);

} // namespace rastertrace
