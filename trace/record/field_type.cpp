// SPDX-License-Identifier: MIT
#include "field_type.h"

#include <rastertrace/core/numbers/number.h>
#include <rastertrace/trace/text/color_text.h>
#include <rastertrace/trace/text/json_scanner.h>

#include <charconv>
#include <system_error>
#include <variant>

namespace rastertrace {

namespace {

/// True if a value, or each value of a list and of the lists in it, is as `is_fine` says.
template <typename IsFine> bool all_in(std::string_view json, IsFine&& is_fine) {
    if (!json.starts_with('['))
        return is_fine(json);
    JsonScanner elements(json);
    while (elements.next_element())
        if (!all_in(elements.value(), is_fine))
            return false;
    return true;
}

bool is_color(std::string_view json) {
    return json.starts_with('"') && parse_color(plain_text(json));
}

} // namespace

std::optional<Index> whole_in(std::string_view json) {
    Index value = 0;
    const char* const end = json.data() + json.size();
    const auto read = std::from_chars(json.data(), end, value);
    if (json.empty() || read.ec != std::errc{} || read.ptr != end)
        return std::nullopt;
    // What lies next to the farthest index is a whole double, too: an empty span ends there.
    if (value < -farthest_index - 1 || value > farthest_index + 1)
        return std::nullopt;
    return value;
}

bool is_not_finite(std::string_view json) {
    return json == R"("NaN")" || json == R"("inf")" || json == R"("-inf")";
}

std::optional<std::string_view> not_finite_in(std::string_view json) {
    std::optional<std::string_view> found;
    all_in(json, [&found](std::string_view value) {
        if (is_not_finite(value))
            found = value;
        return !found;
    });
    return found;
}

bool holds_color(std::string_view name) {
    return name == "color" || name == "colors" || name == "background";
}

bool has_type(std::string_view json, FieldType type) {
    const bool is_string = json.starts_with('"');
    switch (type) {
    case FieldType::whole:
        return whole_in(json).has_value();
    case FieldType::string:
        return is_string;
    case FieldType::boolean:
        return json == "true" || json == "false";
    case FieldType::list:
        return json.starts_with('[');
    case FieldType::quantity:
        break;
    }
    if (!is_string)
        return json.starts_with('-') || (!json.empty() && number_text::is_digit(json.front()));
    return is_not_finite(json) ||
           std::holds_alternative<Number>(parse_number(plain_text(json), NumberSize::any));
}

bool has_type_of(std::string_view json, const StepField& field) {
    if (field.may_be_null() && json == "null")
        return true;
    const bool is_list = field.type == FieldType::list;
    if (is_list != json.starts_with('['))
        return false;
    if (field.is_color)
        return all_in(json, is_color);
    return all_in(json,
                  [&field](std::string_view value) { return has_type(value, field.element); });
}

std::string_view expected_for(FieldType type) {
    switch (type) {
    case FieldType::whole:
        return "a whole number";
    case FieldType::quantity:
        return R"(a number, or an exact one like "25/8")";
    case FieldType::string:
        return "a string";
    case FieldType::boolean:
        return "true or false";
    case FieldType::list:
        break;
    }
    return "an array";
}

std::string_view expected_for(const StepField& field) {
    if (field.is_color)
        return field.type == FieldType::list ? R"(an array of colors like "#ff8000")"
                                             : R"(a color like "#ff8000")";
    if (field.type != FieldType::list)
        return field.may_be_null() ? R"(a number, an exact one like "25/8", or null)"
                                   : expected_for(field.type);
    switch (field.element) {
    case FieldType::string:
        return "an array of strings";
    case FieldType::boolean:
        return "an array of true and false";
    default:
        return R"(an array of numbers, or of exact ones like "25/8")";
    }
}

} // namespace rastertrace
