// SPDX-License-Identifier: MIT
#include "schema_parts.h"

#include "canvas_json.h"
#include "color_text.h"

#include <rastertrace/core/numbers/number.h>

#include <fmt/core.h>

#include <limits>
#include <string>
#include <utility>

namespace rastertrace {

Json open_object_with(std::span<const JsonKey> keys) {
    Json schema{{"type", "object"}, {"properties", Json::object()}};
    Json required = Json::array();
    for (const JsonKey& key : keys) {
        schema["properties"][std::string(key.name)] = reference_to(key.form, key.meaning);
        if (key.is_required)
            required.push_back(key.name);
    }
    if (!required.empty())
        schema["required"] = std::move(required);
    return schema;
}

Json object_with(std::span<const JsonKey> keys) {
    Json schema = open_object_with(keys);
    schema["additionalProperties"] = false;
    return schema;
}

Json reference_to(std::string_view form, std::string_view meaning) {
    Json reference{{"$ref", fmt::format("#/definitions/{}", form)}};
    if (meaning.empty())
        return reference;
    // In draft 07, what stands beside a "$ref" does not count.
    return {{"description", meaning}, {"allOf", Json::array({std::move(reference)})}};
}

Json one_of(std::span<const JsonWord> words) {
    Json schema{{"enum", Json::array()}, {"enumDescriptions", Json::array()}};
    for (const JsonWord& word : words) {
        schema["enum"].push_back(word.name);
        schema["enumDescriptions"].push_back(word.meaning);
    }
    return schema;
}

Json list_of(std::string_view form, std::size_t least) {
    Json schema{{"type", "array"}, {"items", reference_to(form)}};
    if (least > 0)
        schema["minItems"] = least;
    return schema;
}

Json map_to(std::string_view form) {
    return {{"type", "object"}, {"additionalProperties", reference_to(form)}};
}

Json text_schema() {
    return {{"type", "string"}, {"minLength", 1}};
}

std::string_view number_pattern() {
    // A fraction whose denominator is not 0, or a decimal.
    return R"(^-?[0-9]+(/0*[1-9][0-9]*|(\.[0-9]+)?([eE][+-]?[0-9]+)?)$)";
}

Json number_schema() {
    constexpr double largest = std::numeric_limits<double>::max();
    // A title stands above the meaning of the key that has the number. A description would take its place.
    return {{"title", "A number, like 3 or -0.25, or a fraction in quotes, like \"25/8\""},
            {"type", {"number", "string"}},
            {"minimum", -largest},
            {"maximum", largest},
            {"pattern", number_pattern()},
            {"maxLength", longest_number}};
}

Json color_schema(std::string_view with_alpha) {
    const Json hexadecimal{
        {"type", "string"},
        {"pattern", fmt::format("^#([0-9a-fA-F]{{3}}|[0-9a-fA-F]{{6}}({})?)$", with_alpha)}};
    Json names{{"enum", color_names()}};
    for (const std::string_view name : color_names())
        names["enumDescriptions"].push_back(to_text(*parse_color(name)));
    return {{"title", "A color: #rgb, #rrggbb, #rrggbbaa, or a name of CSS 2.1"},
            {"anyOf", Json::array({std::move(names), hexadecimal})}};
}

void define_canvas(Json& definitions) {
    definitions["canvas"] = object_with(canvas_keys);
    definitions["side"] = {{"type", "integer"}, {"minimum", 1}, {"maximum", largest_canvas_side}};
    definitions["origin"] = one_of(origin_words());
}

Json schema_titled(std::string_view title, std::string_view description) {
    return {{"$schema", "http://json-schema.org/draft-07/schema#"},
            {"title", title},
            {"description", description}};
}

std::string schema_text(const Json& schema) {
    constexpr int indent = 2;
    return schema.dump(indent) + "\n";
}

} // namespace rastertrace
