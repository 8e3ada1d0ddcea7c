// SPDX-License-Identifier: MIT
#include "commands/diff_report.h"

#include "app/load.h"
#include "commands/explain_text.h"

#include <rastertrace/trace/explain/explain.h>
#include <rastertrace/trace/tell/step_text.h>
#include <rastertrace/trace/text/color_text.h>
#include <rastertrace/trace/text/text.h>

#include <algorithm>
#include <array>
#include <string_view>
#include <vector>

namespace rastertrace {

namespace {

constexpr Color of_a(200, 40, 40);
constexpr Color of_b(30, 130, 60);

/// The colors of the marks of a picture (see PictureDifference) that tell a difference.
struct MarkRow {
    char mark;
    Color color;
};
constexpr std::array mark_rows{MarkRow{'!', of_a}, MarkRow{'?', of_b},
                               MarkRow{'~', Color(200, 120, 0)}};

/// JSON of a trace; null where there is none.
JsonText value_json(const std::string& value) {
    return value.empty() ? JsonText(nullptr) : JsonText::of(json_printable(value));
}

JsonText field_json(const FieldDifference& field) {
    JsonText json{{"field", field.name}, {"a", value_json(field.a)}, {"b", value_json(field.b)}};
    return field.distance ? json.add("distance", *field.distance) : json;
}

JsonText step_json(const std::optional<DiffStep>& step) {
    if (!step)
        return nullptr;
    return {{"number", step->number},
            {"line", step->line == 0 ? std::nullopt : std::optional(step->line)},
            {"step", value_json(step->json)},
            {"sentence", step->sentence}};
}

JsonText first_json(const TraceDiff& found) {
    if (!found.first)
        return nullptr;
    const StepDifference& first = *found.first;
    const JsonText led_to{{"pixels", found.led_to.count},
                          {"only_a", found.led_to.only_a},
                          {"only_b", found.led_to.only_b},
                          {"colors", found.led_to.colors},
                          {"owners", found.led_to.owners}};
    return {{"kind", first.kind},
            {"primitive", first.primitive.empty() ? JsonText(nullptr) : first.primitive},
            {"moved", first.is_moved},
            {"a", step_json(first.a)},
            {"b", step_json(first.b)},
            {"fields", JsonText::list(first.fields, field_json)},
            {"led_to", led_to}};
}

JsonText kind_json(const KindDifference& kind) {
    const auto summary_json = [](const FieldSummary& field) {
        return JsonText{{"field", field.name}, {"count", field.count}, {"largest", field.largest}};
    };
    return {{"kind", kind.kind},     {"changed", kind.changed},
            {"only_a", kind.only_a}, {"only_b", kind.only_b},
            {"moved", kind.moved},   {"fields", JsonText::list(kind.fields, summary_json)}};
}

JsonText owner_json(const std::optional<PixelOwner>& owner) {
    if (!owner)
        return nullptr;
    return {{"primitive", owner->primitive}, {"color", to_text(owner->color)}};
}

JsonText pixel_json(const PixelDifference& one) {
    return {
        {"x", one.pixel.x}, {"y", one.pixel.y}, {"a", owner_json(one.a)}, {"b", owner_json(one.b)}};
}

JsonText picture_json(const std::optional<PictureDifference>& picture) {
    if (!picture)
        return nullptr;
    return {{"only_a", picture->only_a},
            {"only_b", picture->only_b},
            {"colors", picture->colors},
            {"owners", picture->owners},
            {"pixels", JsonText::list(picture->pixels, pixel_json)},
            {"left", picture->left},
            {"top", picture->top},
            {"down", picture->down},
            {"rows", picture->rows}};
}

} // namespace

std::string explanation_of_first_pixel(const TraceDiff& found, const Trace& trace) {
    const Pixel pixel = found.picture->pixels.front().pixel;
    return explanation_text(
        value_or_throw(explain(trace, {.about = Topic::pixel, .pixel = pixel})));
}

std::string diff_summary(const TraceDiff& found) {
    if (found.is_same)
        return found.damage.empty() ? said("the same##pictures")
                                    : said("the same, as far as they go");
    std::vector<std::string> parts;
    if (const std::uint64_t steps = count_steps(found); steps > 0)
        parts.push_back(counted_differences(steps, "step"));
    if (const std::uint64_t pixels = count_pixels(found); pixels > 0)
        parts.push_back(counted_differences(pixels, "pixel"));
    if (!found.header.empty() || !found.end.empty())
        parts.push_back(said("the header differs"));
    return joined(parts, ", ");
}

std::string without_kinds(const std::string& text) {
    return text.substr(0, text.find("\n\n" + heading_of_kinds() + " ")) + "\n";
}

std::string sentence_of(const std::optional<DiffStep>& step) {
    return step ? step->sentence : said("no such step");
}

std::string diff_in_color(const std::string& text, ColorDepth colors) {
    if (colors == ColorDepth::none)
        return text;
    std::string colored;
    bool is_picture = false;
    for (const std::string& line : split_at(text, '\n')) {
        is_picture = is_picture ? !line.starts_with('#') && !line.empty()
                                : line.starts_with(heading_of_pictures());
        if (line.starts_with("a ") || line.starts_with("b ")) {
            colored += styled(line, {.foreground = line.front() == 'a' ? of_a : of_b}, colors);
        } else if (is_picture && line.find("x = ") == std::string::npos) {
            for (const char c : line) {
                const auto row = std::ranges::find(mark_rows, c, &MarkRow::mark);
                const std::string mark(1, c);
                colored += row == mark_rows.end()
                               ? mark
                               : styled(mark, {.foreground = row->color}, colors);
            }
        } else {
            colored += line;
        }
        colored += '\n';
    }
    colored.pop_back();
    return colored;
}

JsonText diff_json(const TraceDiff& found) {
    std::vector<FieldDifference> header = found.header;
    header.insert(header.end(), found.end.begin(), found.end.end());
    // What is missing of a trace that breaks off may differ.
    const bool is_unknown = found.is_same && !found.damage.empty();
    const auto problem_json = [](const Problem& problem) { return to_text(problem); };
    return {{"same", is_unknown ? std::nullopt : std::optional(found.is_same)},
            {"a", found.name_a},
            {"b", found.name_b},
            {"header", JsonText::list(header, field_json)},
            {"first", first_json(found)},
            {"kinds", JsonText::list(found.kinds, kind_json)},
            {"picture", picture_json(found.picture)},
            {"remarks", found.remarks},
            {"damage", JsonText::list(found.damage, problem_json)}};
}

} // namespace rastertrace
