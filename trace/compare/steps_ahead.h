// SPDX-License-Identifier: MIT
#pragma once

// The steps of a trace, or of a part of one, one after the other, with a look at those ahead.
//
//     StepsAhead steps(trace, 1, trace.size(), {});
//     while (const KeyedStep* step = steps.front())
//         use(*step), steps.pass();

#include <rastertrace/trace/record/trace.h>

#include <cstddef>
#include <deque>
#include <map>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace rastertrace {

/// A step with what it is found by in another trace.
struct KeyedStep {
    const Trace* trace = nullptr;
    std::size_t number = 0; ///< from 1
    std::optional<StepKind> kind{};
    std::string kind_name{};
    std::string
        key{}; ///< its kind, and the fields that tell it from others of its kind in its primitive

    StepView view() const { return trace->step(number); }
};

/// By kinds that we do not know: the fields that tell a step from others of its kind. `name`, `x` and `y` of any other.
using StepKeys = std::map<std::string, std::vector<std::string>>;

class StepsAhead {
public:
    /// Goes from step `first` to step `last`.
    StepsAhead(const Trace& trace, std::size_t first, std::size_t last, StepKeys keys)
        : trace_(trace), next_(first), last_(last), keys_(std::move(keys)) {}

    /// The next step; nullptr behind the last.
    const KeyedStep* front() { return at(0); }

    /// The i-th step from there, from 0.
    const KeyedStep* at(std::size_t i);

    /// The number of the next step; of the last one and 1, behind that.
    std::size_t next() const { return next_; }
    bool is_behind() const { return next_ > last_; }

    /// Goes on by one.
    void pass() {
        ++next_;
        if (!ahead_.empty())
            ahead_.pop_front();
    }

private:
    const Trace& trace_;
    std::size_t next_;
    std::size_t last_;
    StepKeys keys_;
    std::deque<KeyedStep> ahead_; ///< from the next one, as far as somebody has asked
};

} // namespace rastertrace
