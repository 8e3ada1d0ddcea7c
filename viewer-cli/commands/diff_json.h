// SPDX-License-Identifier: MIT
#pragma once

// What two traces do differently, as JSON. docs/diff.md describes the keys.
//
//     print(diff_json(found));

#include <rastertrace/trace/compare/diff.h>

#include <string>

namespace rastertrace {

std::string diff_json(const TraceDiff& found);

} // namespace rastertrace
