// SPDX-License-Identifier: MIT
#include "commands/explain_text.h"
#include "app/json_list.h"

#include <rastertrace/trace/text/text.h>

#include <fmt/core.h>

#include <string_view>
#include <vector>

namespace rastertrace {

namespace {

std::string quoted(const std::string& text) {
    return json_quoted(text);
}

/// The step as the trace has it, with what is said of it as more keys.
std::string step_json(const Try& one) {
    std::string step = one.step.empty() ? "{}" : one.step;
    step.erase(step.find_last_of('}'));
    std::string text =
        fmt::format(R"({}"number":{},"sentence":{})", step.ends_with('{') ? step : step + ",",
                    one.number, json_quoted(one.sentence));
    if (!one.primitive.empty())
        text += fmt::format(R"(,"primitive":{})", json_quoted(one.primitive));
    if (!one.before.empty())
        text += fmt::format(R"(,"before":{},"after":{})", json_quoted(one.before),
                            json_quoted(one.after));
    return text + R"(,"working":)" + list_json(one.working, quoted) + "}";
}

std::string step_or_null(const std::optional<Try>& step) {
    return step ? step_json(*step) : "null";
}

std::string why_not_json(const WhyNot& why) {
    return fmt::format(
        R"({{"primitive":{},"reason":{},"sentence":{},"distance":{},"working":{}}})",
        json_quoted(why.primitive), json_quoted(why.reason), json_quoted(why.sentence),
        why.distance ? fmt::format("{}", *why.distance) : "null", list_json(why.working, quoted));
}

std::string pixel_json(const PixelAlongEdge& one) {
    return fmt::format(R"({{"x":{},"y":{},"owners":{},"told":{},"why":{}}})", one.pixel.x,
                       one.pixel.y, list_json(one.owners, quoted), one.is_told,
                       list_json(one.why, quoted));
}

/// The keys of an answer, without the braces around them.
std::string answer_json(const Explanation& explanation) {
    return fmt::format(R"("answer":{},"tries":{},"why_not":{},"pixels":{},"lacks":{})",
                       json_quoted(explanation.answer), list_json(explanation.tries, step_json),
                       list_json(explanation.why_not, why_not_json),
                       list_json(explanation.pixels, pixel_json),
                       list_json(explanation.lacks, quoted));
}

} // namespace

std::string explanation_json(const Explanation& explanation,
                             const std::optional<OtherAnswer>& other) {
    std::string text = fmt::format(R"({{"question":{},{})", json_quoted(explanation.question),
                                   answer_json(explanation));
    if (!other)
        return text + "}\n";
    const std::string difference =
        other->difference
            ? fmt::format(R"({{"here":{},"there":{}}})", step_or_null(other->difference->one),
                          step_or_null(other->difference->other))
            : "null";
    return text +
           fmt::format(R"(,"against":{{"method":{},{}}},"first_difference":{}}})",
                       json_quoted(other->method), answer_json(other->explanation), difference) +
           "\n";
}

} // namespace rastertrace
