// SPDX-License-Identifier: MIT
// What must be the same in two exercises, and what each slip makes of their numbers.

#include "exercise.h"
#include "slips.h"

#include <rastertrace/trace/record/step_kind.h>
#include <rastertrace/trace/record/traced_steps.h>
#include <rastertrace/trace/tell/formulas_of.h>
#include <rastertrace/trace/tell/step_text.h>

#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <optional>

namespace rastertrace {

namespace {

std::string octant_fact(const std::optional<Index>& octant) {
    return octant ? fmt::format("lines in octant {}", *octant) : "";
}

std::string tie_fact(bool is_tie) {
    return is_tie ? "ties" : "";
}

bool has_denominator(const std::string& number, long denominator) {
    const auto value = number_in(number);
    return value && value->get_den() == denominator;
}

constexpr std::string_view once = ", more than none"; ///< behind what is not counted

/// What of a step is counted, "" for nothing.
std::vector<std::string> facts_of(StepKind kind, const StepView& step) {
    switch (kind) {
    case StepKind::primitive: {
        const auto primitive = step.as<PrimitiveStep>();
        return {primitive.part.is_true() ? "parts" : "times drawn", octant_fact(primitive.octant)};
    }
    case StepKind::edge: {
        const auto edge = step.as<EdgeStep>();
        return {!edge.octant && edge.dx_dy.text() == "null" ? "horizontal edges"
                                                            : octant_fact(edge.octant)};
    }
    case StepKind::face:
        return {step.as<FaceStep>().culled.is_true() ? "culled faces" : "faces that are seen"};
    case StepKind::skip:
        return {"times skipped"};
    case StepKind::scanline: {
        const auto row = step.as<ScanlineStep>();
        return {"rows", tie_fact(has_denominator(row.left.text(), 1)),
                tie_fact(has_denominator(row.right.text(), 1))};
    }
    case StepKind::sample: {
        const auto weights = step.as<SampleStep>().weights.texts();
        const auto is_negative = [](const std::string& weight) { return weight.starts_with('-'); };
        return {tie_fact(std::count(weights.begin(), weights.end(), "0") > 0 &&
                         std::none_of(weights.begin(), weights.end(), is_negative))};
    }
    case StepKind::decide: {
        const auto decision = step.as<DecideStep>();
        const bool is_diagonal = decision.move.text().size() > 1;
        return {"decisions", tie_fact(decision.d.text() == "0"),
                fmt::format("{} steps{}", is_diagonal ? "diagonal" : "straight", once)};
    }
    case StepKind::along:
        return {"pixels along it", tie_fact(has_denominator(step.as<AlongStep>().value.text(), 2))};
    case StepKind::clip:
        return {"cuts"};
    case StepKind::depth:
        return {step.as<DepthStep>().pass.is_true() ? "" : fmt::format("hidden pixels{}", once)};
    default:
        return {};
    }
}

} // namespace

ExerciseFacts exercise_facts(const Trace& trace) {
    ExerciseFacts facts;
    std::string primitive;
    for (std::size_t n = 1; n <= trace.size(); ++n) {
        const auto kind = trace.kind_of(n);
        if (!kind)
            continue;
        if (*kind == StepKind::primitive) {
            primitive = trace.step(n).as<PrimitiveStep>().name.text();
            if (trace.step(n).as<PrimitiveStep>().part.is_true())
                primitive = primitive.substr(0, primitive.find('/'));
        }
        for (const std::string& fact : facts_of(*kind, trace.step(n)))
            if (!fact.empty()) {
                int& count = facts[primitive + ": " + fact];
                count = fact.ends_with(once) ? 1 : count + 1;
            }
    }
    return facts;
}

Answers slip_answers_in(const Trace& trace) {
    constexpr std::array worked_out{StepKind::vertex, StepKind::face,     StepKind::light,
                                    StepKind::edge,   StepKind::scanline, StepKind::decide,
                                    StepKind::along,  StepKind::depth};
    constexpr std::size_t most = 200;
    const Numbers numbers{StepContext(trace)};
    Answers answers(slips().size());
    std::size_t count = 0;
    for (std::size_t n = 1; n <= trace.size() && count < most; ++n) {
        const auto kind = trace.kind_of(n);
        if (!kind || std::count(worked_out.begin(), worked_out.end(), *kind) == 0)
            continue;
        ++count;
        for (const StepField& field : fields_of(*kind)) {
            if (!trace.step(n).field(field.name)) // nobody is asked for it
                continue;
            const auto formulas = formulas_of(numbers, n, field.name);
            for (std::size_t i = 0; !formulas.empty() && i < answers.size(); ++i)
                for (const SlipResult& result : slips()[i].redo(formulas.front())) {
                    std::string& answer = answers[i] ? *answers[i] : answers[i].emplace();
                    answer += fmt::format("{}.{}=", n, field.name);
                    for (const Rational& value : result.values)
                        answer += value.get_str() + ",";
                }
        }
    }
    return answers;
}

} // namespace rastertrace
