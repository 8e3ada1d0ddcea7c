// SPDX-License-Identifier: MIT
// `rastertrace explain`: why something is as it is.

#include "commands.h"
#include "explain_text.h"
#include "load.h"

#include <rastertrace/trace/explain.h>
#include <rastertrace/trace/steps_of_pixel.h>
#include <rastertrace/trace/text.h>

#include <fmt/core.h>

#include <optional>
#include <utility>
#include <variant>

namespace rastertrace {

namespace {

/// The trace of the scene drawn by the method that --against names.
Trace trace_against(const ExplainCommand& command, const InputFrames& input) {
    const auto changes = value_or_throw(parse_method({"--against", command.against}));
    MethodOverrides method = command.method;
    method.insert(method.end(), changes.begin(), changes.end());
    return input.trace_by(input.first(), method);
}

/// The steps of a trace that its pixel needs; none of the others is kept.
Trace steps_of_pixel(StepStream& stream, const ExplainCommand& command) {
    StepsOfPixel chosen(stream.header(), command.question.pixel);
    while (stream.next())
        chosen.take(stream.step(), stream.kind(), stream.number());
    Trace excerpt = std::move(chosen).finish();
    excerpt.title = shown_title(excerpt.title, command.trace);
    excerpt.end = stream.end();
    excerpt.damage = stream.damage();
    excerpt.not_finite = stream.not_finite();
    return excerpt;
}

/// What the trace drawn by another method answers; that it has no answer is one too.
Explanation answer_there(const Trace& against, const Trace& trace, const Question& question) {
    const auto same = question_for(against, trace, question);
    if (!same)
        return {.answer = "there is no such step"};
    auto answer = explain(against, *same);
    return answer ? std::move(answer.value())
                  : Explanation{.answer = "no answer: " + answer.problem().message};
}

/// Answers the question, and once more with the trace drawn by another method, if there is one.
ExitStatus tell(const ExplainCommand& command, const Trace& trace, const Trace* against = nullptr) {
    const Explanation explanation = value_or_throw(explain(trace, command.question));
    std::optional<OtherAnswer> other;
    if (against != nullptr)
        other = {command.against, answer_there(*against, trace, command.question),
                 first_difference(trace, *against, command.question)};
    if (command.json) {
        print(explanation_json(explanation, other));
    } else {
        print(shortened(printable(trace.title), 79) + "\n");
        print(explanation_text(explanation));
        if (other)
            print(other_answer_text(*other));
    }
    return report_damage(trace);
}

} // namespace

int run(const ExplainCommand& command) {
    const SceneOptions options{
        .method = command.method, .limits = command.input, .frames = command.frames};
    if (!command.against.empty()) {
        InputFrames input(command.trace, options);
        const Trace against = trace_against(command, input);
        return tell(command, input.trace(input.first()), &against);
    }
    if (command.question.about != Topic::pixel)
        return tell(command, load_trace(command.trace, options));
    auto opened = open_input(command.trace, options);
    if (auto* const steps = std::get_if<StepStream>(&opened))
        return tell(command, steps_of_pixel(*steps, command));
    InputFrames input(command.trace, std::get<Source>(std::move(opened)), options);
    return tell(command, input.trace(input.first()));
}

} // namespace rastertrace
