// SPDX-License-Identifier: MIT
// Matchers about steps: a pixel, a row, a face, a depth test.

#include "question.h"

#include <rastertrace/trace/audit/redo.h>
#include <rastertrace/trace/record/traced_steps.h>
#include <rastertrace/trace/text/text.h>

#include <fmt/core.h>

#include <algorithm>
#include <map>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace rastertrace::matchers {

namespace {

using Name = std::optional<std::string>;

bool is_at(const StepView& step, Pixel pixel) {
    return x_in(step) == pixel.x && y_in(step) == pixel.y;
}

/// Throws a Problem if a trace has no step of a kind: what it does not tell of any primitive is not false of one.
void expect_any(const Trace& trace, StepKind kind, std::string_view of) {
    if (trace.next_of({kind}, 1, trace.size()) > trace.size())
        throw problem_of("",
                         fmt::format("expected a trace with {} steps{}, found one that has none",
                                     name_of(kind), of));
}

/// True if the header has stages, which tell whether faces are culled.
bool tells_stages(const TestedTrace& tested) {
    const std::string_view text = tested.text;
    return text.substr(0, text.find(R"("step":)")).find(R"("stages":)") != std::string_view::npos;
}

/// Who has not drawn a pixel, and why: all primitives, or one and its parts.
std::string why_not_text(const Explanation& explanation, const Name& primitive) {
    constexpr std::size_t most_told = 12; // more are counted
    std::string text;
    std::size_t told = 0;
    for (const WhyNot& one : explanation.why_not) {
        if (primitive && one.primitive != *primitive &&
            !one.primitive.starts_with(*primitive + "/"))
            continue;
        if (++told > most_told)
            continue;
        text += fmt::format("\n  {}: {}: {}", printable(one.primitive), one.reason, one.sentence);
        for (const std::string& line : one.working)
            text += "\n      " + line;
    }
    if (told > most_told)
        text += fmt::format("\n  and {} more", told - most_told);
    return text;
}

/// What the trace says of a pixel that is not as it was expected to be.
std::string told_of_pixel(const Trace& trace, Pixel pixel, const Name& primitive) {
    const auto explanation = explain(trace, {.about = Topic::pixel, .pixel = pixel});
    if (!explanation)
        throw explanation.problem();
    return fmt::format("{}: {}", explanation.value().question, explanation.value().answer) +
           why_not_text(explanation.value(), primitive);
}

TraceMatcher plots_pixel(Pixel pixel, Name primitive, Caller caller) {
    const std::string what =
        fmt::format("({}, {}){}", pixel.x, pixel.y, primitive ? " in " + *primitive : "");
    return matcher_of(
        {"plots pixel " + what, "does not plot pixel " + what}, caller,
        [pixel, primitive = std::move(primitive)](const TestedTrace& tested) -> Verdict {
            const Trace& trace = trace_or_throw(tested);
            expect_on_canvas(trace.canvas, pixel);
            if (primitive)
                expect_primitive(trace, *primitive);
            const auto steps = find_steps(trace, StepKind::pixel, primitive,
                                          [&](const StepView& step) { return is_at(step, pixel); });
            if (!steps.empty())
                return {true, fmt::format("pixel ({}, {}) is plotted", pixel.x, pixel.y) +
                                  text_of_steps(trace, steps)};
            expect_told(trace, {StepKind::pixel}, pixel, primitive);
            if (!trace.end || trace.end->pixels != 0)
                expect_any(trace, StepKind::pixel, "");
            return {false, told_of_pixel(trace, pixel, primitive)};
        });
}

void expect_number(const Value& value) {
    if (!value.number())
        throw problem_of("", fmt::format("expected a number, like 3.125 or 25/8, found \"{}\"",
                                         printable(value.text())));
}

TraceMatcher has_scanline(int y, const Value& left, const Value& right, Name primitive,
                          Caller caller) {
    const std::string what = fmt::format("scanline y={} from {} to {}{}", y, left.text(),
                                         right.text(), primitive ? " in " + *primitive : "");
    return matcher_of(
        {"has " + what, "does not have " + what}, caller,
        [y, left, right, primitive = std::move(primitive)](const TestedTrace& tested) -> Verdict {
            const Trace& trace = trace_or_throw(tested);
            expect_number(left);
            expect_number(right);
            expect_row_on_canvas(trace.canvas, y);
            if (primitive)
                expect_primitive(trace, *primitive);
            const auto rows = find_steps(trace, StepKind::scanline, primitive,
                                         [y](const StepView& row) { return y_in(row) == y; });
            const bool holds = std::any_of(rows.begin(), rows.end(), [&](std::size_t n) {
                const auto row = trace.step(n).as<ScanlineStep>();
                return left.is(row.left.text()) && right.is(row.right.text());
            });
            if (!holds)
                expect_told(trace, {StepKind::scanline}, Pixel{trace.canvas.left(), y}, primitive);
            if (rows.empty()) {
                expect_any(trace, StepKind::scanline, "");
                return {false, fmt::format("no primitive has the row y={}", y)};
            }
            return {holds, fmt::format("row y={} is", y) + text_of_steps(trace, rows)};
        });
}

TraceMatcher fails_depth(Pixel pixel, const std::string& primitive, Caller caller) {
    const std::string what =
        fmt::format("the depth test of {} at ({}, {})", primitive, pixel.x, pixel.y);
    return matcher_of(
        {"fails " + what, "does not fail " + what}, caller,
        [pixel, primitive](const TestedTrace& tested) -> Verdict {
            const Trace& trace = trace_or_throw(tested);
            expect_on_canvas(trace.canvas, pixel);
            expect_primitive(trace, primitive);
            const auto tests = find_steps(trace, StepKind::depth, primitive,
                                          [&](const StepView& step) { return is_at(step, pixel); });
            if (tests.empty()) {
                expect_told(trace, {StepKind::depth, StepKind::pixel}, pixel, primitive);
                return {.why = "no such test; " + told_of_pixel(trace, pixel, primitive),
                        .is_open = true};
            }
            const bool holds = std::any_of(tests.begin(), tests.end(), [&](std::size_t n) {
                return trace.step(n).as<DepthStep>().pass.is_false();
            });
            return {holds, "the test is" + text_of_steps(trace, tests)};
        });
}

} // namespace

TraceMatcher PlotsPixel(int x, int y, Caller caller) {
    return plots_pixel({x, y}, std::nullopt, caller);
}

TraceMatcher PlotsPixel(int x, int y, const In& primitive, Caller caller) {
    return plots_pixel({x, y}, primitive.name(), caller);
}

TraceMatcher HasScanline(int y, const Value& left, const Value& right, Caller caller) {
    return has_scanline(y, left, right, std::nullopt, caller);
}

TraceMatcher HasScanline(int y, const Value& left, const Value& right, const In& primitive,
                         Caller caller) {
    return has_scanline(y, left, right, primitive.name(), caller);
}

TraceMatcher CullsFace(const std::string& name, Caller caller) {
    return matcher_of({"culls face " + name, "does not cull face " + name}, caller,
                      [name](const TestedTrace& tested) -> Verdict {
                          const Trace& trace = trace_or_throw(tested);
                          const auto tests = find_steps(
                              trace, StepKind::face, std::nullopt,
                              [&name](const StepView& face) { return name_in(face) == name; });
                          if (tests.empty()) {
                              expect_told(trace, {StepKind::face}, std::nullopt, name);
                              expect_primitive(trace, name);
                              if (!tells_stages(tested))
                                  expect_any(trace, StepKind::face, " or with stages");
                              return {false, "the trace does not test this face"};
                          }
                          const bool holds =
                              std::any_of(tests.begin(), tests.end(), [&](std::size_t n) {
                                  return trace.step(n).as<FaceStep>().culled.is_true();
                              });
                          return {holds, "the test is" + text_of_steps(trace, tests)};
                      });
}

TraceMatcher FailsDepth(const std::string& primitive, int x, int y, Caller caller) {
    return fails_depth({x, y}, primitive, caller);
}

TraceMatcher DecidesByItsNumbers(Caller caller) {
    return matcher_of({"decides by its numbers", "does not decide by its numbers"}, caller,
                      [](const TestedTrace& tested) -> Verdict {
                          const Trace& trace = trace_or_throw(tested);
                          const Redone redone = redo(trace);
                          if (redone.values() == 0)
                              throw problem_of("", nothing_redone());
                          return {redone.wrong == 0, redone.wrong == 0
                                                         ? "all steps do"
                                                         : to_text(problem_of(redone, trace))};
                      });
}

} // namespace rastertrace::matchers
