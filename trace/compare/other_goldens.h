// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

namespace rastertrace {

/// Goldens that are accepted besides `NAME.golden.jsonl`: `NAME.gcc.golden.jsonl`, in the same folder, by name.
std::vector<std::string> other_goldens(const std::string& golden);

} // namespace rastertrace
