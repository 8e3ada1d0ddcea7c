// SPDX-License-Identifier: MIT
#pragma once

// The numbers of a trace as formulas take them. A claim may go on from a number that was claimed before: so every
// number is asked for by where it stands, and a wrong one that was claimed can take its place.
//
//     const Numbers right(StepContext(trace));
//     const Numbers numbers(right, wrong);
//     numbers.of(14, "left");  // {1/4}, if somebody claims that

#include "formula.h"
#include "step_text.h"

#include <rastertrace/trace/record/step_context.h>

#include <cstddef>
#include <limits>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

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
std::string name_of_number(const Trace& trace, std::size_t step, std::string_view field);

/// The numbers of a trace, some of which may be replaced by claimed ones.
class Numbers {
public:
    explicit Numbers(const StepContext& steps) : steps_(steps) {}

    /// All claims replace what they are about, and what comes of it. The right numbers must outlive these.
    Numbers(const Numbers& right, const WrongNumbers& wrong)
        : steps_(right.steps_), right_(&right), wrong_(&wrong),
          last_order_(std::numeric_limits<std::size_t>::max()) {}

    /// Claims up to this one replace what they are about, and nothing else.
    Numbers(const Numbers& right, const WrongNumbers& wrong, std::size_t last_order)
        : steps_(right.steps_), right_(&right), wrong_(&wrong), last_order_(last_order),
          works_out_(false) {}

    /// Those of the trace.
    const Numbers& right() const { return right_ == nullptr ? *this : *right_; }

    /// True if claims replace only what they are about. Then a row's end may be worked out from the row above,
    /// and that one from the row below, without going in a circle.
    bool takes_only_claims() const { return !works_out_; }

    const StepContext& steps() const { return steps_; }
    const Trace& trace() const { return steps_.trace(); }
    StepView step(std::size_t n) const { return trace().step(n); }

    /// What a field says, as numbers; nothing if it holds anything else. Where a number that it comes of has been
    /// replaced, it is worked out again.
    Values of(std::size_t step, std::string_view field) const;
    std::optional<Rational> one(std::size_t step, std::string_view field) const;

    /// Where a corner of a primitive is drawn.
    std::optional<Vec2> corner(const PrimitiveText& primitive, std::size_t i) const;

    /// Where a vertex is in a space, or in the last of those before it where it is told: nothing has moved it since.
    std::optional<Vec3> place_in(const std::string& vertex, Space space) const;

    /// The same of a face's corners; nothing if one is not told there, or there are fewer than three.
    std::optional<std::vector<Vec3>> corners_in(const std::vector<std::string>& names,
                                                Space space) const;

    /// The wrong number that was taken last, nullptr for none; then forgets it.
    const WrongNumber* take_used() const { return std::exchange(used_, nullptr); }

private:
    struct WorkedOut {
        Values values; ///< empty: nothing that the number comes of has been replaced
        const WrongNumber* from = nullptr;
    };

    const Values& told(std::size_t step, std::string_view field) const;
    const WrongNumber* replacement(const std::string& name) const;
    const WorkedOut& worked_out(std::size_t step, std::string_view field,
                                const std::string& name) const;

    StepContext steps_;
    const Numbers* right_ = nullptr;
    const WrongNumbers* wrong_ = nullptr;
    std::size_t last_order_ = 0;
    bool works_out_ = true;
    mutable const WrongNumber* used_ = nullptr;
    mutable std::map<std::pair<std::size_t, std::string>, Values> told_; ///< that were asked for
    mutable std::map<std::string, WorkedOut> worked_out_; ///< by the names of numbers
};

} // namespace rastertrace
