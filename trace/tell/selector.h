// SPDX-License-Identifier: MIT
#pragma once

// Which steps of a trace are meant: the one grammar for all commands.
//
//     14, first, last               a step by its number; 0 is before the first
//     scanline y=2                  steps of a kind in which every field named has that value
//     depth x=3 y=2 fail            a word for a boolean: pass, fail, culled, drawn, inside, outside
//     pixel 3,2; edge AB            a value alone: x and y, or what the kind is told apart by; AB is BA, if there is no AB
//     pixel in=ABC                  those that belong to a primitive, or to a part of it
//
//     const auto rows = parse_selector({"--every", "scanline y=2"}, trace);
//     const auto steps = matching_steps(rows.value(), trace); // {14}

#include <rastertrace/trace/record/trace.h>

#include <rastertrace/core/numbers/number.h>
#include <rastertrace/trace/text/problem.h>

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

namespace rastertrace {

/// A value that a field of a step must have.
struct FieldCondition {
    std::string field;            ///< "in": the name of the step's primitive
    std::string value;            ///< as text; of a list without blanks and quotes
    std::optional<Number> number; ///< the same, if it is compared as a number: 1/2 is 0.5
    std::size_t offset = 0;       ///< of its word in the text
};

/// Which steps are meant: one by its number, or all of a kind that meet every condition.
struct Selector {
    Source source;                            ///< the text, and what messages call it
    std::optional<std::size_t> number;        ///< from 0
    std::string kind;                         ///< if there is no number
    std::vector<FieldCondition> conditions{}; ///< in the order in which they were named
};

/// Reads a selector for the steps of a trace: of a kind that it has, with fields that this kind has.
/// The problem of a text that is none points into the text.
Result<Selector> parse_selector(Source source, const Trace& trace);

/// True if step n is meant. `primitive` is the number of the step of the primitive that it belongs
/// to, 0 for none, as Replay::primitive tells.
bool matches(const Selector& selector, const Trace& trace, std::size_t n, std::size_t primitive);

/// Every step that is meant, in order. That there is none is a problem: it names the values nearest
/// to what was asked for.
Result<std::vector<std::size_t>> matching_steps(const Selector& selector, const Trace& trace);

/// The only step that is meant. That there are several is a problem, which names them; `hint` says
/// what to do then.
Result<std::size_t> matching_step(const Selector& selector, const Trace& trace,
                                  std::string hint = {});

} // namespace rastertrace
