// SPDX-License-Identifier: MIT
#include "renames.h"

#include <rastertrace/trace/record/traced_steps.h>
#include <rastertrace/trace/tell/step_text.h>
#include <rastertrace/trace/text/json_scanner.h>
#include <rastertrace/trace/text/text.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <vector>

namespace rastertrace {

namespace {

/// The fields that name a primitive, a vertex or an edge, or have a list of such names.
constexpr std::array<std::string_view, 11> fields_with_names{
    "name",  "vertices", "edge",    "left_edge", "right_edge", "edges",
    "names", "ears",     "side_of", "beside",    "behind"};

} // namespace

void Renames::add_name(const std::string& in_a, const std::string& in_b) {
    const std::string of_b = json_quoted(in_b);
    const auto [known, is_new] = a_of_b_.try_emplace(of_b, json_quoted(in_a));
    if (!is_new && known->second != json_quoted(in_a))
        known->second = of_b;
}

void Renames::add(const std::string& step_a, const std::string& step_b) {
    const PrimitiveText a = primitive_in(StepView(step_a));
    const PrimitiveText b = primitive_in(StepView(step_b));
    add_name(a.name, b.name);
    const std::size_t count = b.vertices.size();
    if (a.vertices.size() != count)
        return;
    for (std::size_t i = 0; i < count; ++i) {
        const std::size_t next = (i + 1) % count;
        add_name(a.vertices[i], b.vertices[i]);
        add_name(edge_name(a, i, next), edge_name(b, i, next));
        add_name(edge_name(a, next, i), edge_name(b, next, i));
    }
}

std::string Renames::in_step(std::string_view step, const Renames& fallback) const {
    std::string text;
    std::size_t copied = 0;
    const auto rename = [&](std::string_view name) {
        for (const Renames* const one : {this, &fallback}) {
            const auto known = one->a_of_b_.find(std::string(name));
            if (known == one->a_of_b_.end())
                continue;
            const auto begin = static_cast<std::size_t>(name.data() - step.data());
            text.append(step.substr(copied, begin - copied)).append(known->second);
            copied = begin + name.size();
            return;
        }
    };
    JsonScanner fields(step);
    while (fields.next_field()) {
        if (std::find(fields_with_names.begin(), fields_with_names.end(), fields.key()) ==
            fields_with_names.end())
            continue;
        if (fields.value().starts_with('[')) {
            JsonScanner names(fields.value());
            while (names.next_element())
                rename(names.value());
        } else {
            rename(fields.value());
        }
    }
    return text.append(step.substr(copied));
}

} // namespace rastertrace
