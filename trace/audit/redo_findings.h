// SPDX-License-Identifier: MIT
#pragma once

// What redo_*.cpp have in common: numbers of a trace, in the scalar that it was drawn with, and what is found wrong.
//
//     findings.expect(n, true, step.culled.is_true(), "face: culled");

#include "redo.h"

#include <rastertrace/core/numbers/conversion.h>
#include <rastertrace/trace/record/trace.h>
#include <rastertrace/trace/record/traced_steps.h>
#include <rastertrace/trace/text/text.h>

#include <fmt/core.h>

#include <concepts>
#include <string>
#include <string_view>
#include <type_traits>
#include <utility>
#include <vector>

namespace rastertrace {

/// Thrown where a trace does not tell what a value hangs on. What hangs on a rule that the header does not say is not done
/// again.
struct NotTold {};

/// A value as a message tells it.
inline std::string in_words(bool value) {
    return value ? "true" : "false";
}
inline std::string in_words(const std::string& value) {
    return value;
}
inline std::string in_words(const Rational& value) {
    return value.get_str();
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
template <typename Value> const Value& told_at(const std::vector<Value>& list, std::size_t i) {
    return i < list.size() ? list[i] : throw NotTold();
}

/// Counts the values that are done again, and keeps those that are others in the trace.
class Findings {
public:
    /// What comes of the numbers of step n, against what it tells. `what` is the kind and the field; `of`, which of
    /// several values.
    template <typename A, typename B>
    void expect(std::size_t n, const A& redone, const B& told, const std::string& what,
                std::string_view of = {}) {
        ++redone_.count[what];
        if (!(redone == told))
            add({n, what + std::string(of), in_words(redone), in_words(told)});
    }
    void count(const std::string& what, std::uint64_t times = 1) { redone_.count[what] += times; }

    void add(const WrongDecision& wrong) {
        if (redone_.wrong++ == 0 || wrong.step < redone_.first.step)
            redone_.first = wrong;
        if (redone_.wrong_steps.size() < most_wrong_steps) {
            std::string& values = redone_.wrong_steps[wrong.step];
            values += (values.empty() ? "" : ", ") + wrong.value() + " = " + wrong.redone;
        }
    }

    Redone take() { return std::move(redone_); }

private:
    Redone redone_;
};

} // namespace rastertrace
