// SPDX-License-Identifier: MIT
#include "diff_header.h"

#include "value_difference.h"

#include <rastertrace/trace/record/field_type.h>
#include <rastertrace/trace/text/json_scanner.h>

#include <map>
#include <string>

namespace rastertrace {

namespace {

/// The keys of a header: those of objects in it with a dot, those of stages by their names.
void flatten(std::map<std::string, std::string>& keys, std::vector<std::string>& order,
             const std::string& name, std::string_view value) {
    if (value.starts_with('{')) {
        JsonScanner fields(value);
        while (fields.next_field())
            flatten(keys, order, name + "." + std::string(fields.key()), fields.value());
        return;
    }
    if (name == "stages" && value.starts_with('[')) {
        JsonScanner stages(value);
        while (stages.next_element()) {
            const std::string plane = value_of_stage(stages.value(), "plane").text();
            const std::string key = name + "." + value_of_stage(stages.value(), "stage").text() +
                                    (plane.empty() ? "" : "." + plane);
            if (keys.emplace(key, stages.value()).second)
                order.push_back(key);
        }
        return;
    }
    if (keys.emplace(name, value).second)
        order.push_back(name);
}

struct FlatHeader {
    std::map<std::string, std::string> values;
    std::vector<std::string> order;

    explicit FlatHeader(std::string_view json) {
        JsonScanner fields(json);
        while (fields.next_field()) {
            const std::string_view key = fields.key();
            if (key != "steps" && key != "only" && key != "region" && key != "primitive")
                flatten(values, order, std::string(key), fields.value());
        }
    }

    std::string value(const std::string& key) const {
        const auto found = values.find(key);
        return found == values.end() ? std::string() : found->second;
    }
};

} // namespace

std::vector<FieldDifference> differing_keys(std::string_view header_a, std::string_view header_b) {
    const FlatHeader a(header_a);
    const FlatHeader b(header_b);
    const auto are_alike = [&](const std::string& key) {
        const std::string in_a = a.value(key);
        const std::string in_b = b.value(key);
        if (in_a.empty() || in_b.empty())
            return in_a == in_b;
        if (!in_a.starts_with('{') || !in_b.starts_with('{'))
            return !differ(in_a, in_b, {.type = {}, .is_color = holds_color(key)});
        return value_of_stage(in_a, "kept") == value_of_stage(in_b, "kept") &&
               value_of_stage(in_a, "why") == value_of_stage(in_b, "why").text();
    };
    std::vector<FieldDifference> differences;
    for (const std::string& key : a.order)
        if (!are_alike(key))
            differences.push_back({.name = key, .a = a.value(key), .b = b.value(key)});
    for (const std::string& key : b.order)
        if (a.value(key).empty())
            differences.push_back({.name = key, .b = b.value(key)});
    return differences;
}

TracedText value_of_stage(std::string_view stage, std::string_view key) {
    JsonScanner fields(stage);
    while (fields.next_field())
        if (fields.key() == key)
            return TracedText(fields.value());
    return {};
}

} // namespace rastertrace
