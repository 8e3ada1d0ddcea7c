// SPDX-License-Identifier: MIT
#include "json_reader.h"

#include "json_key.h"

#include "method_names.h"
#include "number_fault.h"
#include "text.h"

#include <fmt/core.h>

#include <algorithm>
#include <optional>
#include <utility>
#include <variant>

namespace rastertrace {

std::string hint_for_key(std::string_view key, const std::vector<std::string_view>& known) {
    const std::string near = did_you_mean(key, known, "\"");
    if (find_method_key(key) == nullptr)
        return near;
    if (key == "convention")
        return R"("convention" belongs beside "method")";
    return fmt::format("\"{0}\" belongs in \"method\": {{\"{0}\": ...}}{1}{2}", key,
                       near.empty() ? "" : "; ", near);
}

void JsonReader::fail(std::size_t offset, std::string message, std::string hint) const {
    throw problem_at(source, offset, std::move(message), std::move(hint));
}

void JsonReader::fail_expecting(const JsonValue& value, std::string_view expected,
                                std::string hint) const {
    fail(value, fmt::format("expected {}, found {}", expected, described(value)), std::move(hint));
}

void JsonReader::allow_keys(const JsonValue& value, std::span<const std::string_view> keys) const {
    std::vector<std::string_view> known(keys.begin(), keys.end());
    const bool takes_schema = std::erase(known, schema_key) > 0;
    if (value.kind != JsonValue::Kind::object)
        fail_expecting(value, fmt::format("an object with the keys {}", joined(known, ", ")));
    for (const auto& [key, member] : value.members())
        if (takes_schema && key.text == schema_key)
            string_in(member, "the path of a schema in quotes");
        else if (std::find(known.begin(), known.end(), key.text) == known.end())
            fail_expecting(key, fmt::format("a key out of {}", joined(known, ", ")),
                           hint_for_key(key.text, known));
}

JsonValue JsonReader::member(const JsonValue& object, std::string_view key) const {
    const auto value = object.find(key);
    if (!value)
        fail(object, fmt::format("expected the key \"{}\", found none", key));
    return *value;
}

std::string JsonReader::string_in(const JsonValue& value, std::string_view expected) const {
    if (value.kind != JsonValue::Kind::string || value.text.empty())
        fail_expecting(value, expected);
    return value.text;
}

JsonElements JsonReader::array_in(const JsonValue& value, std::string_view expected) const {
    if (value.kind != JsonValue::Kind::array)
        fail_expecting(value, expected);
    return value.elements();
}

Number JsonReader::number_in(const JsonValue& value) const {
    if (value.kind != JsonValue::Kind::number && value.kind != JsonValue::Kind::string)
        fail_expecting(value, "a number");
    auto parsed = parse_number(value.text);
    if (auto* number = std::get_if<Number>(&parsed))
        return std::move(*number);
    const NumberFault fault = std::get<NumberFault>(parsed);
    fail_expecting(value, expected_instead_of(fault),
                   fault == NumberFault::malformed ? R"(a fraction is written "25/8", in quotes)"
                                                   : "");
}

Numbers3 JsonReader::numbers3_in(const JsonValue& value, std::string_view expected) const {
    const JsonElements items = array_in(value, expected);
    if (items.size() != 3)
        fail_expecting(value, expected);
    return {number_in(items[0]), number_in(items[1]), number_in(items[2])};
}

} // namespace rastertrace
