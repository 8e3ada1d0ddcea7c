// SPDX-License-Identifier: MIT
// The first decision that differs between two traces of one scene, of those about what was asked.

#include "explanation.h"

#include <rastertrace/trace/steps_of_pixel.h>
#include <rastertrace/trace/text.h>

#include <algorithm>
#include <unordered_map>
#include <utility>

namespace rastertrace {

namespace {

/// A step that decides something: which one it is, and what it decides.
struct Decision {
    std::size_t number; ///< of the step, in its trace
    std::string primitive;
    std::string key;     ///< of its kind, with what tells it from others of its kind
    std::string decided; ///< "" where nothing is: that it is there is what was decided
};

std::string fields_of(const StepView& step, StepKind kind, FieldRole role) {
    std::string text;
    for (const StepField& field : row_of(kind).fields)
        if (field.role == role)
            text += std::string(field.name) + "=" +
                    std::string(step.field(field.name).value_or("")) + " ";
    return text;
}

/// True of the steps that follow from others, and decide nothing themselves.
bool only_sets_up(StepKind kind) {
    return kind == StepKind::matrix || kind == StepKind::edge || kind == StepKind::half ||
           kind == StepKind::ray || kind == StepKind::undecided || kind == StepKind::triangulate ||
           kind == StepKind::primitive;
}

/// The decisions of a trace in their order, and where each of them is.
struct Decisions {
    std::vector<Decision> all;
    std::unordered_map<std::string, std::size_t> places; ///< by primitive and key

    const Decision* find(const Decision& wanted) const {
        const auto found = places.find(wanted.primitive + "\n" + wanted.key);
        return found == places.end() ? nullptr : &all[found->second];
    }
};

Decisions decisions_in(const Trace& trace) {
    Decisions decisions;
    std::string primitive;
    std::unordered_map<std::string, int> count;
    for (std::size_t n = 1; n <= trace.size(); ++n) {
        const auto kind = trace.kind_of(n);
        if (!kind)
            continue;
        const StepView step = trace.step(n);
        if (kind == StepKind::primitive)
            primitive = step.text("name");
        if (only_sets_up(*kind))
            continue;
        // Where there are several of one key, the first is the first, and so on.
        std::string key =
            std::string(name_of(*kind)) + " " + fields_of(step, *kind, FieldRole::key);
        key += std::to_string(++count[primitive + " " + key]);
        decisions.places.emplace(primitive + "\n" + key, decisions.all.size());
        decisions.all.push_back({n, primitive, key, fields_of(step, *kind, FieldRole::decision)});
    }
    return decisions;
}

/// The steps that a question is about.
Trace steps_about(const Trace& trace, const Question& question) {
    if (question.about == Topic::pixel) {
        // Of the rows, only that of the pixel can change it.
        StepsOfPixel chosen(trace, question.pixel);
        for (std::size_t n = 1; n <= trace.size(); ++n)
            if (trace.kind_of(n) != StepKind::scanline ||
                trace.step(n).whole("y") == question.pixel.y)
                chosen.take(trace.step(n), trace.kind_of(n), n);
        return std::move(chosen).finish();
    }
    Trace excerpt = trace.without_steps();
    const auto answer = explain(trace, question);
    if (!answer)
        throw answer.problem();
    if (question.about == Topic::pair) {
        bool is_meant = false;
        const auto names = split_at(question.text, ',');
        for (std::size_t n = 1; n <= trace.size(); ++n) {
            if (trace.kind_of(n) == StepKind::primitive)
                is_meant = std::find(names.begin(), names.end(), trace.step(n).text("name")) !=
                           names.end();
            if (is_meant)
                excerpt.add_to_excerpt(trace.step(n), trace.kind_of(n), n);
        }
        return excerpt;
    }
    for (const Try& one : answer.value().tries)
        if (one.number != 0)
            excerpt.add_to_excerpt(trace.step(one.number), trace.kind_of(one.number), one.number);
    return excerpt;
}

/// The first decision of a primitive that the other trace does not have.
const Decision* first_without_equal(const Decisions& decisions, const Decisions& others,

                                    const std::string& primitive) {
    for (const Decision& one : decisions.all)
        if (one.primitive == primitive && others.find(one) == nullptr)
            return &one;
    return nullptr;
}

/// A step of a whole trace, by its number in it.
std::optional<Try> step_numbered(const Trace& trace, const Trace& excerpt,
                                 const Decision* decision) {
    if (decision == nullptr)
        return std::nullopt;
    return tries_of(trace, {excerpt.number_of(decision->number)}).front();
}

} // namespace

std::optional<Difference> first_difference(const Trace& one, const Trace& other,
                                           const Question& question) {
    const Trace steps = steps_about(one, question);
    const Trace other_steps = steps_about(other, question);
    const auto decisions = decisions_in(steps);
    const auto others = decisions_in(other_steps);
    const auto difference = [&](const Decision* here, const Decision* there) {
        return Difference{step_numbered(one, steps, here),
                          step_numbered(other, other_steps, there)};
    };
    for (const Decision& decision : decisions.all) {
        const Decision* const equal = others.find(decision);
        if (equal == nullptr)
            return difference(&decision,
                              first_without_equal(others, decisions, decision.primitive));
        if (equal->decided != decision.decided)
            return difference(&decision, equal);
    }
    for (const Decision& decision : others.all)
        if (decisions.find(decision) == nullptr)
            return difference(nullptr, &decision);
    return std::nullopt;
}

} // namespace rastertrace
