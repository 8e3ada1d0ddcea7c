// SPDX-License-Identifier: MIT
#pragma once

// Which formula a number of a trace comes of, with the numbers that go into it.
//
//     const Numbers numbers(index);
//     formulas_of(numbers, 14, "left");  // Lerp{.d1 = 2, .i1 = 5, .d2 = -4, .i2 = -3, .i = 2}
//
// A claim may go on from a number that was claimed before. So every number that goes into a formula is asked
// for by where it stands, and a claimed one can take its place.

#include "step_index.h"

#include <rastertrace/core/scene/method.h>
#include <rastertrace/trace/formula.h>

#include <cstddef>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace rastertrace {

/// A number that somebody claims, and that is wrong.
struct WrongNumber {
    Values values;
    std::size_t order = 0; ///< of its claim
    std::size_t line = 0;
};

/// Those of a file of claims, by where they stand.
using WrongNumbers = std::map<std::string, WrongNumber>;

/// Where the value of a field stands, in words that are the same for all traces of a scene: `vertex A screen`.
std::string name_of_number(const StepIndex& index, std::size_t step, std::string_view field);

/// The numbers of a trace, some of which may be replaced by claimed ones.
class Numbers {
public:
    explicit Numbers(const StepIndex& index) : index_(&index) {}

    /// Claims up to this one replace what they are about, but for the number `except`.
    Numbers(const StepIndex& index, const WrongNumbers& wrong, std::size_t last_order,
            std::string except)
        : index_(&index), wrong_(&wrong), last_order_(last_order), except_(std::move(except)) {}

    const StepIndex& index() const { return *index_; }
    const Trace& trace() const { return index_->trace(); }
    StepView step(std::size_t n) const { return trace().step(n); }

    /// What a field says, as numbers; nothing if it holds anything else.
    Values of(std::size_t step, std::string_view field) const;
    std::optional<Rational> one(std::size_t step, std::string_view field) const;

    /// Where a corner of a primitive is drawn.
    std::optional<Vec<Rational, 2>> corner(std::size_t primitive, std::size_t i) const;

    /// Where a vertex is in the world.
    std::optional<Vec<Rational, 3>> in_world(const std::string& vertex) const;

    /// The line of the last claim that a number was taken from; 0 for none.
    std::size_t line_used() const { return line_used_; }

private:
    const WrongNumber* replacement(const std::string& name) const;

    const StepIndex* index_;
    const WrongNumbers* wrong_ = nullptr;
    std::size_t last_order_ = 0;
    std::string except_;
    mutable std::size_t line_used_ = 0;
};

/// The formulas that the value of a field can be worked out by, that of the textbook first. Fields of check.h
/// are known, too. None of what is no result of anything.
std::vector<Formula> formulas_of(const Numbers& numbers, std::size_t step, std::string_view field);

/// Whether a row, a `scanline` step, has the pixel x.
Formula in_row(const Numbers& numbers, std::size_t row, Rational x);

/// The method that a trace was drawn by, as its header tells.
Method method_of(const Trace& trace);

} // namespace rastertrace
