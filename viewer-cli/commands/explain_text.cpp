// SPDX-License-Identifier: MIT
#include "commands/explain_text.h"

#include <rastertrace/trace/tell/step_text.h>
#include <rastertrace/trace/text/language.h>
#include <rastertrace/trace/text/text.h>

#include <fmt/core.h>

#include <algorithm>
#include <cstddef>
#include <map>
#include <string_view>
#include <vector>

namespace rastertrace {

namespace {

std::string lines_below(const std::vector<std::string>& lines, std::size_t indent) {
    std::string text;
    for (const std::string& line : lines)
        text += std::string(indent, ' ') + line + "\n";
    return text;
}

/// How wide a column is: as its widest cell.
template <typename Item>
std::size_t column_width(const std::vector<Item>& items, std::string Item::*cell,
                         std::string_view title) {
    std::size_t width = columns_in(title);
    for (const Item& item : items)
        width = std::max(width, columns_in(printable(item.*cell)));
    return width;
}

/// What a pixel showed (Try::before), in the language of steps.
std::string shown_text(const std::string& shown) {
    constexpr std::string_view background = "background ";
    if (shown.starts_with(background))
        return said("background {}", shown.substr(background.size()));
    return shown == "empty" ? said("empty") : shown;
}

/// One line for each step; what the pixel shows before and after, if the steps are about one.
std::string table_of(std::vector<Try> tries) {
    for (Try& one : tries) {
        one.before = shown_text(one.before);
        one.after = shown_text(one.after);
    }
    const bool has_pixels =
        std::any_of(tries.begin(), tries.end(), [](const Try& one) { return !one.before.empty(); });
    const std::string title_before = said("before");
    const std::string title_after = said("after");
    const std::size_t before = column_width(tries, &Try::before, title_before);
    const std::size_t after = column_width(tries, &Try::after, title_after);
    constexpr std::size_t indent = 6;
    std::string text;
    if (has_pixels)
        text += fmt::format("{}{}  {}\n", padded(said("step"), indent),
                            padded(title_before, before), title_after);
    const bool is_of_several = std::any_of(tries.begin(), tries.end(), [&tries](const Try& one) {
        return one.primitive != tries.front().primitive;
    });
    const std::size_t primitive = column_width(tries, &Try::primitive, "");
    for (const Try& one : tries) {
        text += fmt::format("{:>4}  ", one.number);
        if (has_pixels)
            text += fmt::format("{}  {}  ", padded(one.before, before), padded(one.after, after));
        if (is_of_several)
            text += padded(printable(one.primitive), primitive) + "  ";
        text += one.sentence + "\n" + lines_below(one.working, indent);
    }
    return text;
}

std::string why_not_text(std::vector<WhyNot> why_not) {
    std::string rest;
    if (why_not.size() > most_why_not_told) {
        std::stable_sort(why_not.begin(), why_not.end(), was_nearer_to_drawing);
        std::map<std::string, std::size_t> count;
        for (std::size_t i = most_why_not_told; i < why_not.size(); ++i)
            ++count[why_not[i].reason];
        std::vector<std::string> counts;
        for (const auto& [reason, number] : count)
            counts.push_back(fmt::format("{} {}", number, in_language_of_steps(reason)));
        rest =
            said("  and {} more: {}\n", why_not.size() - most_why_not_told, joined(counts, ", "));
        why_not.resize(most_why_not_told);
    }
    for (WhyNot& one : why_not)
        one.reason = in_language_of_steps(one.reason);
    const std::size_t name = column_width(why_not, &WhyNot::primitive, "");
    const std::size_t reason = column_width(why_not, &WhyNot::reason, "");
    std::string text;
    for (const WhyNot& one : why_not)
        text += fmt::format("  {}  {}  {}\n", padded(printable(one.primitive), name),
                            padded(one.reason, reason), one.sentence) +
                lines_below(one.working, 6);
    return text + rest;
}

std::string pixels_text(const std::vector<PixelAlongEdge>& pixels) {
    const std::string both = said(" and ");
    std::string text;
    for (const PixelAlongEdge& one : pixels) {
        text += fmt::format("({}, {})  {}\n", one.pixel.x, one.pixel.y,
                            !one.is_told         ? said("not told")
                            : one.owners.empty() ? said("neither")
                                                 : printable(joined(one.owners, both)));
        text += lines_below(one.why, 6);
    }
    return text;
}

/// What has been found, below the answer.
std::string details_text(const Explanation& explanation) {
    std::string text;
    if (!explanation.lacks.empty())
        text += "\n" + lines_below(explanation.lacks, 0);
    if (!explanation.tries.empty())
        text += "\n" + table_of(explanation.tries);
    if (!explanation.why_not.empty())
        text += said("\nnot drawn by\n") + why_not_text(explanation.why_not);
    if (!explanation.pixels.empty())
        text += "\n" + pixels_text(explanation.pixels);
    return text;
}

std::string step_text(const std::string& who, const std::optional<Try>& step) {
    return step ? said("  {}  step {}: {}\n", who, step->number, step->sentence)
                : said("  {}  no such step\n", who);
}

/// The step as the trace has it, with what is said of it as more keys.
JsonText try_json(const Try& one) {
    JsonText json = JsonText::of(one.step.empty() ? "{}" : one.step);
    json.add("number", one.number).add("sentence", one.sentence);
    if (!one.primitive.empty())
        json.add("primitive", one.primitive);
    if (!one.before.empty())
        json.add("before", one.before).add("after", one.after);
    return json.add("working", one.working);
}

JsonText why_not_json(const WhyNot& why) {
    return {{"primitive", why.primitive},
            {"reason", why.reason},
            {"sentence", why.sentence},
            {"distance", why.distance},
            {"working", why.working}};
}

JsonText edge_pixel_json(const PixelAlongEdge& one) {
    return {{"x", one.pixel.x},
            {"y", one.pixel.y},
            {"owners", one.owners},
            {"told", one.is_told},
            {"why", one.why}};
}

/// Adds the keys of an answer.
JsonText& add_answer(JsonText& json, const Explanation& explanation) {
    return json.add("answer", explanation.answer)
        .add("tries", JsonText::list(explanation.tries, try_json))
        .add("why_not", JsonText::list(explanation.why_not, why_not_json))
        .add("pixels", JsonText::list(explanation.pixels, edge_pixel_json))
        .add("lacks", explanation.lacks);
}

} // namespace

std::string explanation_text(const Explanation& explanation) {
    return fmt::format("{}: {}\n", explanation.question, explanation.answer) +
           details_text(explanation);
}

std::string other_answer_text(const OtherAnswer& other) {
    const std::string method = printable(other.method);
    std::string text =
        said("\nwith {}: {}\n", method, other.explanation.answer) + details_text(other.explanation);
    if (!other.difference)
        return text + said("\nno decision about it differs\n");
    const std::string here = padded(said("as it is"), columns_in(method));
    return text + said("\nthe first decision that differs\n") +
           step_text(here, other.difference->one) +
           step_text(padded(method, columns_in(here)), other.difference->other);
}

JsonText explanation_json(const Explanation& explanation, const std::optional<OtherAnswer>& other) {
    JsonText json{{"question", explanation.question}};
    add_answer(json, explanation);
    if (!other)
        return json;
    const auto step_or_null = [](const std::optional<Try>& step) {
        return step ? try_json(*step) : nullptr;
    };
    JsonText against{{"method", other->method}};
    json.add("against", add_answer(against, other->explanation));
    const auto& difference = other->difference;
    return json.add("first_difference", difference
                                            ? JsonText{{"here", step_or_null(difference->one)},
                                                       {"there", step_or_null(difference->other)}}
                                            : nullptr);
}

} // namespace rastertrace
