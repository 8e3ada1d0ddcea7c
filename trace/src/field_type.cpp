// SPDX-License-Identifier: MIT
#include "field_type.h"

#include "json_scanner.h"

#include <rastertrace/core/numbers/number.h>

#include <charconv>
#include <system_error>
#include <variant>

namespace rastertrace {

namespace {

/// True if a list holds values of a type, or lists of them.
bool has_elements(std::string_view json, FieldType type) {
    JsonScanner elements(json);
    while (elements.next_element()) {
        const std::string_view value = elements.value();
        if (!has_type(value, type) && !(value.starts_with('[') && has_elements(value, type)))
            return false;
    }
    return true;
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
    return std::holds_alternative<Number>(parse_number(plain_text(json), NumberSize::any));
}

bool has_type_of(std::string_view json, const StepField& field) {
    if (field.may_be_null && json == "null")
        return true;
    return has_type(json, field.type) &&
           (field.type != FieldType::list || has_elements(json, element_type_of(field)));
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
    if (field.type != FieldType::list)
        return field.may_be_null ? R"(a number, an exact one like "25/8", or null)"
                                 : expected_for(field.type);
    switch (element_type_of(field)) {
    case FieldType::string:
        return "an array of strings";
    case FieldType::boolean:
        return "an array of true and false";
    default:
        return R"(an array of numbers, or of exact ones like "25/8")";
    }
}

} // namespace rastertrace
