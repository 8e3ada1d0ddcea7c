// SPDX-License-Identifier: MIT
#pragma once

// The numbers of a trace as formulas take them. A claim may go on from a number that was claimed before: so every
// number is asked for by where it stands, and a wrong one that was claimed can take its place.
//
//     const Numbers numbers(index, wrong);
//     numbers.of(14, "left");  // {1/4}, if somebody claims that

#include "step_index.h"

#include <rastertrace/trace/tell/formula.h>

#include <cstddef>
#include <limits>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <utility>

namespace rastertrace {

/// A number that somebody claims, and that is wrong.
struct WrongNumber {
    Values values;
    std::size_t order = 0; ///< of its claim
    std::size_t line = 0;
    std::string field = {};
    bool is_rounded = false; ///< no more than that: it counts as right
};

/// Those of a file of claims, by where they stand.
using WrongNumbers = std::map<std::string, WrongNumber>;

/// Where the value of a field stands, in words that are the same for all traces of a scene: `vertex A screen`.
std::string name_of_number(const StepIndex& index, std::size_t step, std::string_view field);

/// The numbers of a trace, some of which may be replaced by claimed ones.
class Numbers {
public:
    explicit Numbers(const StepIndex& index) : index_(&index) {}

    /// All claims replace what they are about, and what comes of it.
    Numbers(const StepIndex& index, const WrongNumbers& wrong)
        : index_(&index), wrong_(&wrong), last_order_(std::numeric_limits<std::size_t>::max()) {}

    /// Claims up to this one replace what they are about, and nothing else.
    Numbers(const StepIndex& index, const WrongNumbers& wrong, std::size_t last_order)
        : index_(&index), wrong_(&wrong), last_order_(last_order), works_out_(false) {}

    /// True if claims replace only what they are about. Then a row's end may be worked out from the row above,
    /// and that one from the row below, without going in a circle.
    bool takes_only_claims() const { return !works_out_; }

    const StepIndex& index() const { return *index_; }
    const Trace& trace() const { return index_->trace(); }
    StepView step(std::size_t n) const { return trace().step(n); }

    /// What a field says, as numbers; nothing if it holds anything else. Where a number that it comes of has been
    /// replaced, it is worked out again.
    Values of(std::size_t step, std::string_view field) const;
    std::optional<Rational> one(std::size_t step, std::string_view field) const;

    /// Where a corner of a primitive is drawn.
    std::optional<Vec<Rational, 2>> corner(std::size_t primitive, std::size_t i) const;

    /// Where a vertex is in the world.
    std::optional<Vec<Rational, 3>> in_world(const std::string& vertex) const;

    /// The wrong number that was taken last, nullptr for none; then forgets it.
    const WrongNumber* take_used() const { return std::exchange(used_, nullptr); }

private:
    struct WorkedOut {
        Values values; ///< empty: nothing that the number comes of has been replaced
        const WrongNumber* from = nullptr;
    };

    const WrongNumber* replacement(const std::string& name) const;
    const WorkedOut& worked_out(std::size_t step, std::string_view field,
                                const std::string& name) const;

    const StepIndex* index_;
    const WrongNumbers* wrong_ = nullptr;
    std::size_t last_order_ = 0;
    bool works_out_ = true;
    mutable const WrongNumber* used_ = nullptr;
    mutable std::map<std::string, WorkedOut> worked_out_; ///< by the names of numbers
};

} // namespace rastertrace
