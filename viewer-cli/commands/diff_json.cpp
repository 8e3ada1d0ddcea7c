// SPDX-License-Identifier: MIT
#include "commands/diff_json.h"

#include "app/json_list.h"

#include <rastertrace/trace/text/color_text.h>
#include <rastertrace/trace/text/text.h>

#include <fmt/core.h>

#include <string_view>
#include <vector>

namespace rastertrace {

namespace {

/// JSON of a trace; null where there is none.
std::string value_json(const std::string& value) {
    return value.empty() ? "null" : json_printable(value);
}

std::string field_json(const FieldDifference& field) {
    std::string text = fmt::format(R"({{"field":{},"a":{},"b":{})", json_quoted(field.name),
                                   value_json(field.a), value_json(field.b));
    if (field.distance)
        text += fmt::format(R"(,"distance":{})", *field.distance);
    return text + "}";
}

std::string step_json(const DiffStep& step) {
    return fmt::format(R"({{"number":{},"line":{},"step":{},"sentence":{}}})", step.number,
                       step.line == 0 ? "null" : fmt::format("{}", step.line),
                       value_json(step.json), json_quoted(step.sentence));
}

std::string step_or_null(const std::optional<DiffStep>& step) {
    return step ? step_json(*step) : "null";
}

std::string pixels_json(const std::vector<Pixel>& pixels) {
    return list_json(pixels,
                     [](const Pixel& pixel) { return fmt::format("[{},{}]", pixel.x, pixel.y); });
}

std::string first_json(const TraceDiff& found) {
    if (!found.first)
        return "null";
    const StepDifference& first = *found.first;
    return fmt::format(
        R"({{"kind":{},"primitive":{},"moved":{},"a":{},"b":{},"fields":{},)"
        R"("led_to":{{"pixels":{},"only_a":{},"only_b":{},"colors":{},"owners":{}}}}})",
        json_quoted(first.kind), first.primitive.empty() ? "null" : json_quoted(first.primitive),
        first.is_moved, step_or_null(first.a), step_or_null(first.b),
        list_json(first.fields, field_json), found.led_to.count, pixels_json(found.led_to.only_a),
        pixels_json(found.led_to.only_b), pixels_json(found.led_to.colors),
        pixels_json(found.led_to.owners));
}

std::string summary_json(const FieldSummary& field) {
    return fmt::format(R"({{"field":{},"count":{},"largest":{}}})", json_quoted(field.name),
                       field.count, field.largest ? fmt::format("{}", *field.largest) : "null");
}

std::string kind_json(const KindDifference& kind) {
    return fmt::format(
        R"({{"kind":{},"changed":{},"only_a":{},"only_b":{},"moved":{},"fields":{}}})",
        json_quoted(kind.kind), kind.changed, kind.only_a, kind.only_b, kind.moved,
        list_json(kind.fields, summary_json));
}

std::string owner_json(const std::optional<PixelOwner>& owner) {
    return owner ? fmt::format(R"({{"primitive":{},"color":{}}})", json_quoted(owner->primitive),
                               json_quoted(to_text(owner->color)))
                 : "null";
}

std::string pixel_json(const PixelDifference& one) {
    return fmt::format(R"({{"x":{},"y":{},"a":{},"b":{}}})", one.pixel.x, one.pixel.y,
                       owner_json(one.a), owner_json(one.b));
}

std::string picture_json(const std::optional<PictureDifference>& picture) {
    if (!picture)
        return "null";
    const auto quoted = [](const std::string& row) { return json_quoted(row); };
    return fmt::format(R"({{"only_a":{},"only_b":{},"colors":{},"owners":{},"pixels":{},)"
                       R"("left":{},"top":{},"down":{},"rows":{}}})",
                       picture->only_a, picture->only_b, picture->colors, picture->owners,
                       list_json(picture->pixels, pixel_json), picture->left, picture->top,
                       picture->down, list_json(picture->rows, quoted));
}

} // namespace

std::string diff_json(const TraceDiff& found) {
    const auto quoted = [](const std::string& remark) { return json_quoted(remark); };
    std::vector<FieldDifference> header = found.header;
    header.insert(header.end(), found.end.begin(), found.end.end());
    // What is missing of a trace that breaks off may differ.
    const std::string_view same = !found.is_same ? "false" : found.damage.empty() ? "true" : "null";
    return fmt::format(
        R"({{"same":{},"a":{},"b":{},"header":{},"first":{},"kinds":{},)"
        R"("picture":{},"remarks":{},"damage":{}}})"
        "\n",
        same, json_quoted(found.name_a), json_quoted(found.name_b), list_json(header, field_json),
        first_json(found), list_json(found.kinds, kind_json), picture_json(found.picture),
        list_json(found.remarks, quoted), list_json(found.damage, [](const Problem& problem) {
            return json_quoted(to_text(problem));
        }));
}

} // namespace rastertrace
