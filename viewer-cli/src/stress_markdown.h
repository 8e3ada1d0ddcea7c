// SPDX-License-Identifier: MIT
#pragma once

// The catalogue of stiff and extreme cases as a page: an entry for each case.

#include "run_case.h"

#include <string>
#include <vector>

namespace rastertrace {

/// The cases by family, under headings, with their input, what holds and what goes wrong, and the commands that draw
/// their scenes.
std::string as_markdown(const std::vector<RunCase>& cases);

} // namespace rastertrace
