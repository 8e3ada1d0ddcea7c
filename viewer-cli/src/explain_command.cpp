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

/// The question asked again, of the scene drawn by the method that --against names.
OtherAnswer answer_against(const ExplainCommand& command, InputFrames& input, const Trace& trace) {
    const auto changes = value_or_throw(parse_method({"--against", command.against}));
    MethodOverrides method = command.method;
    method.insert(method.end(), changes.begin(), changes.end());
    const Trace other = input.trace_by(input.first(), method);
    return {command.against, value_or_throw(explain(other, command.question)),
            first_difference(trace, other, command.question)};
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
    return excerpt;
}

ExitStatus tell(const ExplainCommand& command, const Trace& trace, InputFrames* input) {
    const Explanation explanation = value_or_throw(explain(trace, command.question));
    std::optional<OtherAnswer> other;
    if (input != nullptr && !command.against.empty())
        other = answer_against(command, *input, trace);
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
    const bool can_stream = command.question.about == Topic::pixel && command.against.empty();
    if (!can_stream) {
        InputFrames input(command.trace, options);
        return tell(command, input.trace(input.first()), &input);
    }
    auto opened = open_input(command.trace, options);
    if (auto* const steps = std::get_if<StepStream>(&opened))
        return tell(command, steps_of_pixel(*steps, command), nullptr);
    InputFrames input(command.trace, std::get<Source>(std::move(opened)), options);
    return tell(command, input.trace(input.first()), &input);
}

} // namespace rastertrace
