// SPDX-License-Identifier: MIT
#pragma once

// What the slips of all kinds of formulas are made with, and their rows of the one table (slips.h).

#include "slips.h"

#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <variant>
#include <vector>

namespace rastertrace {

/// Collects what a formula comes to with a mistake in it, and leaves out what is right all the same.
class SlipResults {
public:
    explicit SlipResults(const Formula& formula) : right_(value_of(formula)) {}

    void add(Values values, std::string detail = {}) {
        if (!values.empty() && values != right_)
            results_.push_back({std::move(values), std::move(detail)});
    }
    void add(const std::optional<Rational>& value) {
        if (value)
            add(Values{*value});
    }
    void add(const Vec<Rational, 3>& v) { add(Values{v.x, v.y, v.z}); }
    void add_formula(const Formula& formula, std::string detail = {}) {
        add(value_of(formula), std::move(detail));
    }

    const Values& right() const { return right_; }
    std::vector<SlipResult> take() { return std::move(results_); }

private:
    Values right_;
    std::vector<SlipResult> results_;
};

/// Words of a slip that is a known mistake of programs, too (mistakes.h): they are that one's.
struct AsMistake {
    constexpr operator Words() const { return ""; }
    constexpr operator std::string_view() const { return {}; }
};
inline constexpr AsMistake as_mistake;

/// The formula, if it is of this form.
template <typename Form> const Form* as_form(const Formula& formula) {
    return std::get_if<Form>(&formula.of);
}

/// above / below, if there is such a number.
inline std::optional<Rational> divided(const Rational& above, const Rational& below) {
    return sgn(below) == 0 ? std::nullopt : std::optional<Rational>(above / below);
}

/// The slips of Bresenham's line.
std::span<const Slip> slips_of_lines();

/// The slips of matrices.
std::span<const Slip> slips_of_matrices();

} // namespace rastertrace
