// SPDX-License-Identifier: MIT
#pragma once

// A trace that is read piece by piece, so that its first steps are there while the rest is read.
//
//     auto opened = GrowingTrace::open("trace.jsonl", {});  // throws a Problem
//     if (auto* growing = std::get_if<GrowingTrace>(&opened))
//         while (!growing->is_whole())
//             growing->read_on();  // growing->trace() has more steps each time
//
// The text stays in its file, or, of a pipe, in a temporary one without a name; in memory is where each step is.

#include "trace.h"

#include <rastertrace/trace/text/input.h>
#include <rastertrace/trace/text/problem.h>

#include <cstddef>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <variant>

namespace rastertrace {

class GrowingTrace {
public:
    /// Opens a file ("-" for standard input): a trace to be read; or, if it has not one step a line, all that the
    /// file holds. Throws a Problem.
    static std::variant<GrowingTrace, Source> open(const std::string& path,
                                                   const InputLimits& limits);

    /// A trace that is there whole.
    explicit GrowingTrace(Trace trace);
    GrowingTrace(GrowingTrace&&) noexcept;
    GrowingTrace& operator=(GrowingTrace&&) noexcept;
    ~GrowingTrace();

    /// The steps so far, from the first. Its end and its damage are those of the whole trace once it is whole. It
    /// stays at its place, also if this is moved.
    const Trace& trace() const;

    /// Gives it a title, if it has none.
    void name_untitled(const std::string& title);

    /// Lets the sentences of wrong steps say what their numbers give, see Trace::numbers_give.
    void let_numbers_give(std::map<std::size_t, std::string> values_of_steps);

    /// Reads a piece more, some ten thousand steps; false if there is none, or none yet. What cannot be read on from
    /// is damage, and the end.
    bool read_on();

    /// All has been read.
    bool is_whole() const;

    /// How much of the file has been read, from 0 to 1; of a pipe nobody knows: 0.
    double share() const;

    /// The pipe that more may come from, to be waited for; -1: none.
    int pipe() const;

    /// Waits until there is more from it.
    void wait_for_pipe() const;

    /// Why the file is not what was read any more, if somebody has cut it short or written it anew, in the language of
    /// steps. Its steps must not be looked at then.
    std::optional<std::string> change() const;

private:
    struct State;
    explicit GrowingTrace(std::unique_ptr<State> state);

    std::unique_ptr<State> state_;
};

} // namespace rastertrace
