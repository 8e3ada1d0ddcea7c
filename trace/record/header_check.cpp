// SPDX-License-Identifier: MIT
#include "header_check.h"

#include "field_type.h"

#include <fmt/core.h>

#include <algorithm>
#include <string_view>
#include <utility>

namespace rastertrace {

namespace {

using Kind = JsonValue::Kind;

bool is_string(const JsonValue& value) {
    return value.kind == Kind::string;
}

bool is_index(const JsonValue& value) {
    return value.kind == Kind::number && whole_in(value.text).has_value();
}

/// What a value of a form is called; "" if `value` is one, or if the reader refuses whatever is none.
std::string_view expected_instead(const JsonValue& value, std::string_view form) {
    const auto elements = value.elements();
    const auto members = value.members();
    if (form == "string")
        return is_string(value) ? "" : "a string";
    if (form == "boolean")
        return value.kind == Kind::boolean ? "" : "true or false";
    if (form == "counts")
        return value.kind == Kind::object ? "" : "an object";
    if (form == "stages")
        return value.kind == Kind::array ? "" : "an array";
    if (form == "strings")
        return value.kind == Kind::array && std::all_of(elements.begin(), elements.end(), is_string)
                   ? ""
                   : "an array of strings";
    if (form == "region")
        return elements.size() == 4 && std::all_of(elements.begin(), elements.end(), is_index)
                   ? ""
                   : "an array of four whole numbers";
    const auto is_word = [](const JsonMember& member) {
        return is_string(member.value) || member.value.kind == Kind::number;
    };
    if (form == "method")
        return value.kind == Kind::object && std::all_of(members.begin(), members.end(), is_word)
                   ? ""
                   : "an object of strings and numbers";
    return "";
}

} // namespace

std::vector<WrongForm> wrong_forms(const JsonValue& object, std::span<const HeaderKey> keys) {
    if (object.kind != Kind::object)
        return {{object.begin, fmt::format("expected an object, found {}", described(object))}};
    std::vector<WrongForm> found;
    for (const HeaderKey& key : keys) {
        const auto value = object.find(key.name);
        if (!value && key.is_required)
            found.push_back(
                {object.begin, fmt::format("expected the key \"{}\", found none", key.name)});
        if (!value)
            continue;
        if (const auto expected = expected_instead(*value, key.form); !expected.empty())
            found.push_back({value->begin, fmt::format("expected {} for {}, found {}", expected,
                                                       key.name, described(*value))});
        else if (key.form == "stages")
            for (const JsonValue& stage : value->elements())
                for (WrongForm& wrong : wrong_forms(stage, stage_keys))
                    found.push_back(std::move(wrong));
    }
    return found;
}

} // namespace rastertrace
