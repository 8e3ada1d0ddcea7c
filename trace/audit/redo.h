// SPDX-License-Identifier: MIT
#pragma once

// What is told is what decided: the decisions of a trace, taken again from the numbers beside them.
//
//     const Redone redone = redo(trace);
//     if (redone.wrong > 0)
//         use(redone.first.step, redone.first.what);  // 11, "scanline: from"

#include <rastertrace/trace/record/trace.h>

#include <cstddef>
#include <cstdint>
#include <map>
#include <string>

namespace rastertrace {

/// A value that is not the one that its numbers give.
struct WrongDecision {
    std::size_t step = 0; ///< from 1
    std::string what;   ///< kind and field: "scanline: from"; behind them, which of several values
    std::string redone; ///< the value, done again
    std::string told;   ///< the one in the trace

    /// The field: "from"; with which of several values.
    std::string field() const;
    std::string value() const;
};

struct Redone {
    std::map<std::string, std::uint64_t>
        count;               ///< how many values were done again, by kind and field
    std::uint64_t wrong = 0; ///< how many of them are others in the trace
    WrongDecision first;     ///< if there is one

    /// Of the first steps with such values, by their number: what their numbers give, "from = -1, to = 2".
    std::map<std::size_t, std::string> wrong_steps;

    std::uint64_t values() const; ///< all that were done again
};

/// So many wrong steps are kept.
inline constexpr std::size_t most_wrong_steps = 10'000;

/// Does every step again, in the scalar that the header names: each primitive is drawn again from its corners. What the
/// trace does not tell the numbers or the rule of is left out. The trace must have all its steps.
Redone redo(const Trace& trace);

/// Why a trace with no value that can be done again is neither right nor wrong.
std::string nothing_redone();

/// A larger trace is not done again for the sentences of its wrong steps: it would take too long. `validate --redo` does.
inline constexpr std::uint64_t largest_marked_trace = 16'000'000; // bytes

/// Does a trace again, if it has all its steps, and lets the sentences of its wrong steps say so (Trace::numbers_give).
void mark_wrong_steps(Trace& trace);

/// What is said of the first wrong decision, at its place in the file: what its numbers give, and the sentence that tells
/// it. There has to be one.
Problem problem_of(const Redone& redone, const Trace& trace);

} // namespace rastertrace
