// SPDX-License-Identifier: MIT
#include "question.h"

#include <rastertrace/trace/explain/explanation.h>
#include <rastertrace/trace/record/traced_steps.h>
#include <rastertrace/trace/record/write_trace.h>
#include <rastertrace/trace/scene/refusal.h>
#include <rastertrace/trace/scene/scene_file.h>
#include <rastertrace/trace/text/input.h>
#include <rastertrace/trace/text/text.h>
#include <rastertrace/trace/text/trace_layout.h>

#include <fmt/core.h>

#include <algorithm>
#include <memory>
#include <ostream>
#include <string_view>
#include <utility>

namespace rastertrace::matchers {

namespace {

/// What is read of a trace that was written, or the first thing that is wrong with it.
Result<Trace> sound(Result<Trace> trace) {
    if (trace && !trace.value().damage.empty())
        return trace.value().damage.front();
    return trace;
}

TestedTrace drawn(const Scene& scene, const Plan& plan, const std::string& name) {
    std::string text;
    StringOutput output(text);
    write_trace(scene, plan, {}, output);
    return {name, text, sound(read_trace({name, text}))};
}

/// Asks one question. That it could not be answered is told once, where the test asked.
class Question final : public ::testing::MatcherInterface<const TestedTrace&> {
public:
    Question(Wording wording, Caller caller, std::function<Verdict(const TestedTrace&)> decide)
        : wording_(std::move(wording)), caller_(caller), decide_(std::move(decide)) {}

    bool MatchAndExplain(const TestedTrace& tested,
                         ::testing::MatchResultListener* listener) const override {
        try {
            const Verdict verdict = decide_(tested);
            if (verdict.is_open)
                return refuse(tested, verdict.why, listener);
            *listener << verdict.why;
            return verdict.holds;
        } catch (const Problem& problem) {
            return refuse(tested, to_text(problem), listener);
        }
    }

    void DescribeTo(std::ostream* out) const override { *out << wording_.is; }
    void DescribeNegationTo(std::ostream* out) const override { *out << wording_.is_not; }

private:
    /// GoogleTest asks again to explain a test that failed, and Not() would turn a refusal into success.
    bool refuse(const TestedTrace& tested, const std::string& why,
                ::testing::MatchResultListener* listener) const {
        const std::string text = fmt::format("cannot tell if it {}: {}", wording_.is, why);
        if (!std::exchange(has_told_, true))
            ADD_FAILURE_AT(caller_.file(), caller_.line())
                << fmt::format("{}\n{}", printable(tested.name), text);
        *listener << text;
        return true;
    }

    Wording wording_;
    Caller caller_;
    std::function<Verdict(const TestedTrace&)> decide_;
    mutable bool has_told_ = false;
};

} // namespace

TestedTrace trace_in(const std::string& path, const MethodOverrides& method) {
    Result<Source> source = read_source(path, InputLimits{});
    if (!source)
        return {path, {}, source.problem()};
    return trace_from(std::move(source.value()), method);
}

TestedTrace trace_of(const Scene& scene) {
    const std::string name = scene.title.empty() ? "the scene" : scene.title;
    if (const auto unfit = find_unfit(scene)) {
        const Refusal refusal = refusal_of(scene, *unfit);
        return {name, {}, problem_of("", refusal.message, refusal.hint)};
    }
    return drawn(scene, plan_for(scene), name);
}

TestedTrace trace_from(Source source, const MethodOverrides& method) {
    const std::string name = source.name;
    if (is_trace(source)) {
        if (!method.empty())
            return {name,
                    {},
                    problem_of(name, fmt::format("expected a scene to draw with {} {}, found a "
                                                 "trace, which is drawn already",
                                                 method.front().first, method.front().second))};
        std::string text = source.text;
        return {name, std::move(text), sound(read_trace(std::move(source)))};
    }
    const auto scene = read_scene(source, method);
    if (!scene)
        return {name, {}, scene.problem()};
    return drawn(scene.value().scene, scene.value().plan, name);
}

void PrintTo(const TestedTrace& tested, std::ostream* out) {
    *out << printable(tested.name);
    if (tested.trace)
        *out << fmt::format(", {} steps", tested.trace.value().size());
}

TraceMatcher matcher_of(Wording wording, Caller caller,
                        std::function<Verdict(const TestedTrace&)> decide) {
    wording = {printable(wording.is), printable(wording.is_not)};
    return ::testing::MakeMatcher(new Question(std::move(wording), caller, std::move(decide)));
}

const Trace& trace_or_throw(const TestedTrace& tested) {
    if (!tested.trace)
        throw tested.trace.problem();
    return tested.trace.value();
}

void expect_told(const Trace& trace, std::initializer_list<StepKind> kinds,
                 std::optional<Pixel> pixel, const std::optional<std::string>& primitive) {
    Trace told = trace.without_steps();
    if (primitive && *primitive == trace.left_out.primitive)
        told.left_out.primitive.clear();
    const std::vector<std::string> lacks = what_lacks(told, kinds, pixel);
    if (!lacks.empty())
        throw problem_of("", joined(lacks, "; "));
}

void expect_on_canvas(const Canvas& canvas, Pixel pixel) {
    if (!canvas.contains(pixel.x, pixel.y))
        throw problem_of(
            "",
            fmt::format("expected a pixel of the canvas (x {} to {}, y {} to {}), found ({}, {})",
                        canvas.left(), canvas.right(), std::min(canvas.top(), canvas.bottom()),
                        std::max(canvas.top(), canvas.bottom()), pixel.x, pixel.y));
}

void expect_row_on_canvas(const Canvas& canvas, int y) {
    if (!canvas.contains(canvas.left(), y))
        throw problem_of("", fmt::format("expected a row of the canvas (y {} to {}), found {}",
                                         std::min(canvas.top(), canvas.bottom()),
                                         std::max(canvas.top(), canvas.bottom()), y));
}

std::vector<std::size_t> find_steps(const Trace& trace, StepKind kind,
                                    const std::optional<std::string>& primitive,
                                    const std::function<bool(const StepView&)>& is_meant) {
    std::vector<std::size_t> steps;
    bool is_primitives = !primitive;
    for (std::size_t n = 1; n <= trace.size(); ++n) {
        if (primitive && trace.kind_of(n) == StepKind::primitive) {
            const auto begun = trace.step(n).as<PrimitiveStep>();
            is_primitives = begun.name == *primitive || is_part_of(begun, *primitive);
        }
        if (is_primitives && trace.kind_of(n) == kind && is_meant(trace.step(n)))
            steps.push_back(n);
    }
    return steps;
}

void expect_primitive(const Trace& trace, const std::string& name) {
    if (trace.lacks(StepKind::primitive))
        throw problem_of("", fmt::format("expected a trace with primitive steps, to find {} in; "
                                         "they were left out",
                                         printable(name)));
    std::vector<std::string> names;
    for (const std::size_t n : trace.steps_of({StepKind::primitive})) {
        const auto begun = trace.step(n).as<PrimitiveStep>();
        if (begun.name == name || is_part_of(begun, name))
            return;
        names.push_back(begun.name.text());
    }
    constexpr std::size_t most_named = 12;
    const std::size_t named = std::min(names.size(), most_named);
    throw problem_of("",
                     fmt::format("expected a primitive of the trace ({}{}), found {}",
                                 printable(joined(std::span(names).first(named), ", ")),
                                 names.size() > named ? ", ..." : "", printable(name)),
                     did_you_mean(name, {names.begin(), names.end()}));
}

std::string text_of_steps(const Trace& trace, const std::vector<std::size_t>& steps) {
    std::string text;
    for (const Try& one : tries_of(trace, steps)) {
        text += fmt::format("\n  step {}: {}", one.number, one.sentence);
        for (const std::string& line : one.working)
            text += "\n      " + line;
    }
    return text;
}

} // namespace rastertrace::matchers
