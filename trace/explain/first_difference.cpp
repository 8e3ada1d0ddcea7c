// SPDX-License-Identifier: MIT
// The first decision that differs between two traces of one scene, of those about what was asked.

#include "explanation.h"
#include "steps_of_pixel.h"

#include <rastertrace/trace/text/text.h>

#include <algorithm>
#include <unordered_map>
#include <utility>

namespace rastertrace {

namespace {

/// A step: which one it is, and what it decides.
struct Decision {
    std::size_t number; ///< in its trace
    StepKind kind;
    std::string primitive;
    std::string key;     ///< of its kind, with what tells it from others of its kind
    std::string decided; ///< "" where nothing is: that it is there is what was decided
};

std::string told_by(const StepView& step, StepKind kind, FieldRole role) {
    std::string text;
    for (const StepField& field : fields_of(kind))
        if (field.role == role)
            text += std::string(field.name) + "=" + step.field(field.name).value_or("") + " ";
    return text;
}

/// True of the steps that follow from others, and decide nothing themselves.
bool only_sets_up(StepKind kind) {
    return kind == StepKind::matrix || kind == StepKind::edge || kind == StepKind::half ||
           kind == StepKind::ray || kind == StepKind::undecided || kind == StepKind::triangulate ||
           kind == StepKind::primitive;
}

/// True if a vertex is somewhere else once it has been snapped.
bool is_moved(const VertexStep& vertex) {
    return vertex.snapped && vertex.snapped != vertex.at;
}

std::string decided_by(const StepView& step, StepKind kind) {
    return kind == StepKind::vertex && !is_moved(step.as<VertexStep>())
               ? std::string()
               : told_by(step, kind, FieldRole::decision);
}

/// True of a row that does not have the pixel that is asked about.
bool leaves_out(const ScanlineStep& row, const Question& question) {
    const bool has_pixel = row.from <= question.pixel.x && question.pixel.x <= row.to;
    return question.about == Topic::pixel && !has_pixel;
}

/// True of a step that changes something though the other trace has none like it. Of a primitive, how a row or a
/// line comes to its pixels is none: its pixels are.
bool decides_alone(const StepView& step, StepKind kind, const Question& question) {
    const bool is_about_pixels = question.about == Topic::pixel || question.about == Topic::face ||
                                 question.about == Topic::pair;
    switch (kind) {
    case StepKind::face:
        return step.as<FaceStep>().culled.is_true();
    case StepKind::depth:
        return step.as<DepthStep>().pass.is_false();
    case StepKind::vertex:
        return is_moved(step.as<VertexStep>());
    case StepKind::scanline:
        return !is_about_pixels || leaves_out(step.as<ScanlineStep>(), question);
    case StepKind::sample:
        return !is_about_pixels ||
               (question.about == Topic::pixel && step.as<SampleStep>().inside.is_false());
    case StepKind::crossings:
    case StepKind::along:
    case StepKind::decide:
        return !is_about_pixels;
    default:
        return true;
    }
}

/// The steps of a trace in their order, and where each of them is.
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
            primitive = name_in(step).text();
        // Where there are several of one key, the first is the first, and so on.
        std::string key = std::string(name_of(*kind)) + " " + told_by(step, *kind, FieldRole::key);
        key += std::to_string(++count[primitive + " " + key]);
        decisions.places.emplace(primitive + "\n" + key, decisions.all.size());
        decisions.all.push_back({n, *kind, primitive, key, decided_by(step, *kind)});
    }
    return decisions;
}

/// The steps of primitives of these names, and of their parts.
Trace steps_of(const Trace& trace, const std::vector<std::string>& names) {
    Trace excerpt = trace.without_steps();
    bool is_meant = false;
    for (std::size_t n = 1; n <= trace.size(); ++n) {
        const StepView step = trace.step(n);
        if (trace.kind_of(n) == StepKind::primitive) {
            const auto primitive = step.as<PrimitiveStep>();
            is_meant = std::any_of(names.begin(), names.end(), [&](const std::string& name) {
                return primitive.name == name || is_part_of(primitive, name);
            });
        }
        if (is_meant)
            excerpt.add_to_excerpt(n);
    }
    return excerpt;
}

/// The steps that matter to a pixel; of the rows, only its own can change it.
Trace steps_of(const Trace& trace, Pixel pixel) {
    StepsOfPixel chosen(trace, pixel);
    for (std::size_t n = 1; n <= trace.size(); ++n)
        if (trace.kind_of(n) != StepKind::scanline || y_in(trace.step(n)) == pixel.y)
            chosen.take(n);
    return std::move(chosen).finish();
}

/// The steps that a question is about; none if the trace has no answer to it.
Trace steps_about(const Trace& trace, const Question& question) {
    Trace excerpt = trace.without_steps();
    if (question.about == Topic::pixel)
        return steps_of(trace, question.pixel);
    const auto answer = explain(trace, question);
    if (!answer)
        return excerpt;
    if (question.about == Topic::pair)
        return steps_of(trace, split_at(question.text, ','));
    if (question.about == Topic::face)
        return steps_of(trace, triangles_of_face(trace, question.text));
    for (const Try& one : answer.value().tries)
        if (one.number != 0)
            excerpt.add_to_excerpt(one.number);
    return excerpt;
}

/// The first decision of a primitive that the other trace does not have.
const Decision* first_without_equal(const Decisions& decisions, const Decisions& others,
                                    const std::string& primitive) {
    for (const Decision& one : decisions.all)
        if (!only_sets_up(one.kind) && one.primitive == primitive && others.find(one) == nullptr)
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

std::optional<Question> question_for(const Trace& other, const Trace& trace,
                                     const Question& question) {
    if (question.about != Topic::step)
        return question;
    const auto answer = explain(trace, question);
    if (!answer || answer.value().tries.front().number == 0)
        return question;
    for (const Decision& one : decisions_in(trace).all)
        if (one.number == answer.value().tries.front().number) {
            const Decisions others = decisions_in(other);
            const Decision* const same = others.find(one);
            return same == nullptr ? std::nullopt
                                   : std::optional(Question{.about = Topic::step,
                                                            .text = std::to_string(same->number)});
        }
    return std::nullopt;
}

std::optional<Difference> first_difference(const Trace& one, const Trace& other,
                                           const Question& question) {
    const auto other_question = question_for(other, one, question);
    const Trace steps = steps_about(one, question);
    const Trace other_steps =
        other_question ? steps_about(other, *other_question) : other.without_steps();
    const auto decisions = decisions_in(steps);
    const auto others = decisions_in(other_steps);
    const auto difference = [&](const Decision* here, const Decision* there) {
        return Difference{step_numbered(one, steps, here),
                          step_numbered(other, other_steps, there)};
    };
    const auto decides = [&](const Trace& trace, const Decision& decision) {
        return !only_sets_up(decision.kind) &&
               decides_alone(trace.step(decision.number), decision.kind, question);
    };
    for (const Decision& decision : decisions.all) {
        const Decision* const equal = others.find(decision);
        if (equal == nullptr && decides(steps, decision))
            return difference(&decision,
                              first_without_equal(others, decisions, decision.primitive));
        if (equal != nullptr && !only_sets_up(decision.kind) && equal->decided != decision.decided)
            return difference(&decision, equal);
    }
    for (const Decision& decision : others.all)
        if (decisions.find(decision) == nullptr && decides(other_steps, decision))
            return difference(first_without_equal(decisions, others, decision.primitive),
                              &decision);
    return std::nullopt;
}

} // namespace rastertrace
