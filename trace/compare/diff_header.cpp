// SPDX-License-Identifier: MIT
#include "diff_header.h"

#include "value_difference.h"

#include <rastertrace/trace/record/field_type.h>
#include <rastertrace/trace/record/trace.h>
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
            const StepView stage(stages.value());
            const std::string plane = stage.text("plane");
            const std::string key =
                name + "." + stage.text("stage") + (plane.empty() ? "" : "." + plane);
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
        const StepView stage_a(in_a);
        const StepView stage_b(in_b);
        return stage_a.text("kept") == stage_b.text("kept") &&
               stage_a.text("why") == stage_b.text("why");
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

} // namespace rastertrace
