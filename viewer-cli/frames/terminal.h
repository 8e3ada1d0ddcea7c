// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <limits>

namespace rastertrace {

/// How much text fits; no limit where nobody said.
struct TextSize {
    std::size_t columns = std::numeric_limits<std::size_t>::max();
    std::size_t lines = std::numeric_limits<std::size_t>::max();
};

/// The size of the terminal that standard output goes to. For a file or pipe, what COLUMNS and
/// LINES say, if they are set.
TextSize output_size();

} // namespace rastertrace
