// SPDX-License-Identifier: MIT
#pragma once

// Which formula a number of a trace comes of, with the numbers that go into it.
//
//     const Numbers numbers(index);
//     formulas_of(numbers, 14, "left");  // Lerp{.d1 = 2, .i1 = 5, .d2 = -4, .i2 = -3, .i = 2}

#include "numbers.h"

#include <rastertrace/trace/tell/formula.h>

#include <cstddef>
#include <string_view>
#include <vector>

namespace rastertrace {

/// The formulas that the value of a field can be worked out by, that of the textbook first. Fields of check.h
/// are known, too. None of what is no result of anything.
std::vector<Formula> formulas_of(const Numbers& numbers, std::size_t step, std::string_view field);

/// Whether a row, a `scanline` step, has the pixel x.
Formula in_row(const Numbers& numbers, std::size_t row, Rational x);

} // namespace rastertrace
