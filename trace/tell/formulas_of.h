// SPDX-License-Identifier: MIT
#pragma once

// Which formula a number of a trace comes of, with the numbers that go into it.
//
//     const Numbers numbers(StepContext(trace));
//     formulas_of(numbers, 14, "left");  // Lerp{.d1 = 2, .i1 = 5, .d2 = -4, .i2 = -3, .i = 2}

#include "formula.h"
#include "numbers.h"

#include <rastertrace/core/transform/matrix.h>

#include <cstddef>
#include <optional>
#include <string_view>
#include <variant>
#include <vector>

namespace rastertrace {

/// The formulas that the value of a field can be worked out by, that of the textbook first. Fields of check.h
/// are known, too. None of what is no result of anything. Of several matrices, a vertex has the one that gives its place,
/// or the nearest.
std::vector<Formula> formulas_of(const Numbers& numbers, std::size_t step, std::string_view field);

/// The first of them, if it has this form.
template <typename Form>
std::optional<Form> form_of(const Numbers& numbers, std::size_t step, std::string_view field) {
    const std::vector<Formula> formulas = formulas_of(numbers, step, field);
    const auto* const form = formulas.empty() ? nullptr : std::get_if<Form>(&formulas.front().of);
    return form == nullptr ? std::nullopt : std::optional(*form);
}

/// Whether a row, a `scanline` step, has the pixel x.
Formula in_row(const Numbers& numbers, std::size_t row, Rational x);

/// The matrix of a `matrix` step; nothing if it does not tell all four rows, or one holds no numbers.
std::optional<Matrix<Rational>> exact_matrix_in(const MatrixStep& step);

/// The matrices that a `matrix` step tells its matrix to be the product of; none if it does not.
std::vector<MatrixTimes::Factor> factors_in(const MatrixStep& step);

/// A step for each pixel that a primitive has, in the order in which it has them: the test of one that is hidden.
std::vector<std::size_t> pixels_of(const StepContext& steps, std::size_t primitive);

} // namespace rastertrace
