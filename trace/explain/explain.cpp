// SPDX-License-Identifier: MIT
#include "explain.h"

#include "explanation.h"

#include <rastertrace/trace/tell/describe.h>
#include <rastertrace/trace/tell/selector.h>
#include <rastertrace/trace/tell/step_text.h>
#include <rastertrace/trace/tell/working.h>
#include <rastertrace/trace/text/color_text.h>
#include <rastertrace/trace/text/language.h>
#include <rastertrace/trace/text/text.h>

#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <utility>

namespace rastertrace {

namespace {

constexpr std::array<Words, 7> topics{
    {"pixel", "scanline", "face", "vertex", "edge", "pair", "step"}};

const Words& words_for(Topic topic) {
    return topics[static_cast<std::size_t>(topic)];
}

/// A pixel, or a row, that is asked about has to be on the canvas.
std::optional<Problem> off_canvas(const Canvas& canvas, const Question& question) {
    const bool is_row = question.about == Topic::scanline;
    const Pixel& pixel = question.pixel;
    if (canvas.contains(is_row ? canvas.left() : pixel.x, pixel.y))
        return std::nullopt;
    const int low = std::min(canvas.top(), canvas.bottom());
    const int high = std::max(canvas.top(), canvas.bottom());
    return problem_of(
        "", is_row ? fmt::format("--scanline: expected a row of the canvas (y {} to {}), found {}",
                                 low, high, pixel.y)
                   : fmt::format("--pixel: expected a pixel of the canvas (x {} to {}, y {} to "
                                 "{}), found {},{}",
                                 canvas.left(), canvas.right(), low, high, pixel.x, pixel.y));
}

Explanation explain_step(const Trace& trace, const std::string& selector) {
    const auto parsed = parse_selector({"--step", selector}, trace);
    if (!parsed)
        throw parsed.problem();
    const auto step = matching_step(parsed.value(), trace, "say which");
    if (!step)
        throw step.problem();
    Explanation explanation{.tries = tries_of(trace, {step.value()})};
    Replay replay(trace);
    replay.go_to(step.value());
    explanation.answer = said("step {} of {}", step.value(), trace.size());
    if (replay.primitive() != 0)
        explanation.answer +=
            said(", of {}", printable(name_in(trace.step(replay.primitive())).text()));
    return explanation;
}

Explanation answer_to(const Question& question, const Trace& trace) {
    switch (question.about) {
    case Topic::pixel:
        return explain_pixel(trace, question);
    case Topic::scanline:
        return explain_scanline(trace, question.pixel.y);
    case Topic::face:
        return explain_face(trace, question.text);
    case Topic::vertex:
        return explain_vertex(trace, question.text);
    case Topic::edge:
        return explain_edge(trace, question.text);
    case Topic::pair:
        return explain_pair(trace, question.text);
    case Topic::step:
        break;
    }
    return explain_step(trace, question.text);
}

} // namespace

std::string_view name_of(Topic topic) {
    return words_for(topic).in(Language::english);
}

std::string to_text(const Question& question) {
    const std::string_view topic = words_for(question.about).in(language_of_steps());
    if (question.about == Topic::pixel)
        return fmt::format("{} ({}, {})", topic, question.pixel.x, question.pixel.y);
    if (question.about == Topic::scanline)
        return fmt::format("{} y={}", topic, question.pixel.y);
    return fmt::format("{} {}", topic, printable(question.text));
}

bool was_nearer_to_drawing(const WhyNot& one, const WhyNot& other) {
    const bool is_hidden = one.reason == "hidden";
    if (is_hidden != (other.reason == "hidden"))
        return is_hidden;
    if (one.distance.has_value() != other.distance.has_value())
        return one.distance.has_value();
    return one.distance && *one.distance < *other.distance;
}

Try try_of(const Replay& replay) {
    const Trace& trace = replay.trace();
    if (replay.step() == 0)
        return {.sentence = describe_step(replay)};
    return {.number = trace.number_of(replay.step()),
            .step = trace.step(replay.step()).json(),
            .sentence = describe_step(replay),
            .working = working_of(replay)};
}

std::string shown_at(const Replay& replay, Pixel pixel) {
    const Trace& trace = replay.trace();
    const Frame& frame = replay.frame();
    const std::size_t drawn_by = frame.drawn_by[trace.canvas.offset_of(pixel)];
    if (drawn_by == 0)
        return trace.background ? "background " + to_text(*trace.background) : std::string("empty");
    const std::size_t primitive = replay.primitive_of(drawn_by);
    const std::string color = to_text(frame.image.at(pixel));
    return primitive == 0
               ? color
               : fmt::format("{} {}", printable(name_in(trace.step(primitive)).text()), color);
}

std::vector<Try> tries_of(const Trace& trace, const std::vector<std::size_t>& steps) {
    std::vector<Try> tries;
    Replay replay(trace, {.depths = true});
    for (const std::size_t n : steps) {
        replay.go_to(n == 0 ? 0 : n - 1);
        const auto x = n == 0 ? std::nullopt : x_in(trace.step(n));
        const auto y = n == 0 ? std::nullopt : y_in(trace.step(n));
        const bool is_pixel = x && y && trace.canvas.contains(*x, *y);
        const Pixel pixel{static_cast<int>(x.value_or(0)), static_cast<int>(y.value_or(0))};
        const std::string before = is_pixel ? shown_at(replay, pixel) : std::string();
        replay.go_to(n);
        tries.push_back(try_of(replay));
        tries.back().before = before;
        tries.back().after = is_pixel ? shown_at(replay, pixel) : std::string();
    }
    return tries;
}

bool is_part_of(const PrimitiveStep& primitive, std::string_view whole) {
    return primitive.part.is_true() && name_of_whole(primitive) == whole;
}

Result<Explanation> explain(const Trace& trace, const Question& question) {
    const bool is_on_canvas = question.about == Topic::pixel || question.about == Topic::scanline;
    if (is_on_canvas)
        if (auto problem = off_canvas(trace.canvas, question))
            return *std::move(problem);
    try {
        Explanation explanation = answer_to(question, trace);
        explanation.question = to_text(question);
        return explanation;
    } catch (const Problem& problem) {
        return problem;
    }
}

} // namespace rastertrace
