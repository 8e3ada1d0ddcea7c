// SPDX-License-Identifier: MIT
#pragma once

// Numbers of a trace in the scalar that it was drawn with, rounded to pixels, and told in messages: what redo_steps.h
// does steps again with.

#include <rastertrace/core/numbers/conversion.h>
#include <rastertrace/core/raster/canvas.h>
#include <rastertrace/core/raster/rounding.h>
#include <rastertrace/trace/record/traced_steps.h>
#include <rastertrace/trace/text/color_text.h>
#include <rastertrace/trace/text/text.h>

#include <fmt/core.h>

#include <concepts>
#include <string>
#include <type_traits>
#include <vector>

namespace rastertrace {

namespace redo_steps {

/// Thrown where a trace does not tell what a decision hangs on.
struct NotTold {};

/// A value as a message tells it.
inline std::string in_words(bool value) {
    return value ? "true" : "false";
}
inline std::string in_words(const std::string& value) {
    return value;
}
inline std::string in_words(const TracedNumber& value) {
    return value.text();
}
inline std::string in_words(const Rational& value) {
    return value.get_str();
}
inline std::string in_words(Color value) {
    return to_text(value);
}
template <typename Number>
requires std::is_arithmetic_v<Number> std::string in_words(Number value) {
    return fmt::format("{}", value);
}
template <typename Value> std::string in_words(const std::vector<Value>& values) {
    std::vector<std::string> words;
    for (const Value& value : values)
        words.push_back(in_words(value));
    return "(" + joined(words, ", ") + ")";
}

/// A number of a trace, exactly: of a fraction or a whole number all digits, else the double.
inline Rational exactly(const TracedNumber& told) {
    const auto number = told.exact();
    if (!number)
        throw NotTold();
    const bool is_double = told.text().find_first_of(".e") != std::string::npos;
    return is_double ? Rational(*told.nearest_double()) : *number;
}

/// The same in the numbers that a scene is drawn with.
template <typename Real> Real number_of(const TracedNumber& told) {
    if constexpr (std::same_as<Real, float>)
        return nearest_float(told.exact() ? *told.exact() : throw NotTold());
    else if constexpr (std::same_as<Real, double>)
        return told.nearest_double() ? *told.nearest_double() : throw NotTold();
    else
        return exactly(told);
}
template <typename Real> std::vector<Real> numbers_of(const TracedList<TracedNumber>& list) {
    std::vector<Real> numbers;
    for (const TracedNumber& told : list.values())
        numbers.push_back(number_of<Real>(told));
    return numbers;
}
inline Rational exactly(double number) {
    return Rational(number);
}
inline Rational exactly(const Rational& number) {
    return number;
}

/// A whole number, not rounded: a canvas is small.
template <typename Real> Real whole(Index index) {
    if constexpr (std::floating_point<Real>)
        return static_cast<Real>(index);
    else
        return Rational(static_cast<long>(index));
}

/// A number rounded by a rule, without a rounding of its own.
inline Index floor_of(const Rational& number) {
    mpz_class whole;
    mpz_fdiv_q(whole.get_mpz_t(), number.get_num_mpz_t(), number.get_den_mpz_t());
    const mpz_class farthest(static_cast<long>(farthest_index));
    if (whole > farthest)
        return farthest_index;
    return whole < -farthest ? -farthest_index : whole.get_si();
}
inline Index ceil_of(const Rational& number) {
    return -floor_of(-number);
}
inline Index nearest_of(const Rational& number, Ties ties) {
    const Index down = ceil_of(number - Rational(1, 2));
    const Index up = floor_of(number + Rational(1, 2));
    if (down == up)
        return down;
    switch (ties) {
    case Ties::start:
        return down;
    case Ties::up:
    case Ties::step:
        return up;
    case Ties::away:
        return number < 0 ? down : up;
    case Ties::even:
        break;
    }
    return down % 2 == 0 ? down : up;
}
inline Index pixel_of(const Rational& number, const SpanRounding& rule, bool is_last) {
    switch (rule.rounding) {
    case Rounding::floor:
        return floor_of(number);
    case Rounding::nearest:
        return nearest_of(number, rule.ties);
    case Rounding::truncate:
        return number < 0 ? ceil_of(number) : floor_of(number);
    case Rounding::half_open:
        return is_last ? ceil_of(number) - 1 : ceil_of(number);
    case Rounding::inside:
        break;
    }
    return is_last ? floor_of(number) : ceil_of(number);
}

} // namespace redo_steps

} // namespace rastertrace
