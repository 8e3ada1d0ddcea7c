// SPDX-License-Identifier: MIT
#pragma once

// What every matcher is made of: a question about a trace, and the words around it.
//
//     return matcher_of({"plots pixel (3, 2)", "does not plot pixel (3, 2)"}, caller,
//                       [](const TestedTrace& tested) -> Verdict { ... });

#include <rastertrace/testing.h>

#include <rastertrace/trace/explain/explain.h>

#include <cstddef>
#include <functional>
#include <initializer_list>
#include <optional>
#include <string>
#include <vector>

namespace rastertrace::matchers {

/// What was found out.
struct Verdict {
    bool holds = false;
    std::string why{};    ///< what the trace says, several lines; for who expected something else
    bool is_open = false; ///< neither it nor its opposite holds: fails the test, as a Problem does
};

/// How a matcher is called in messages.
struct Wording {
    std::string is{};
    std::string is_not{};
};

/// A matcher that asks `decide`. A Problem that it throws fails the test, whatever stands around the matcher.
TraceMatcher matcher_of(Wording wording, Caller caller,
                        std::function<Verdict(const TestedTrace&)> decide);

/// The trace, or its problem, thrown.
const Trace& trace_or_throw(const TestedTrace& tested);

/// Throws a Problem if steps were left out of the trace that an answer rests on.
void expect_told(const Trace& trace, std::initializer_list<StepKind> kinds,
                 std::optional<Pixel> pixel = {}, const std::optional<std::string>& primitive = {});

/// Throws a Problem if the canvas does not have the pixel, or the row.
void expect_on_canvas(const Canvas& canvas, Pixel pixel);
void expect_row_on_canvas(const Canvas& canvas, int y);

/// The steps of a kind that are `primitive`'s, or anyone's, and that `is_meant`.
std::vector<std::size_t> find_steps(const Trace& trace, StepKind kind,
                                    const std::optional<std::string>& primitive,
                                    const std::function<bool(const StepView&)>& is_meant);

/// Throws a Problem if no primitive has this name.
void expect_primitive(const Trace& trace, const std::string& name);

/// What steps say, with their working.
std::string text_of_steps(const Trace& trace, const std::vector<std::size_t>& steps);

} // namespace rastertrace::matchers
