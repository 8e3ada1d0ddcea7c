// SPDX-License-Identifier: MIT
#include "step_index.h"

#include <rastertrace/trace/record/traced_steps.h>
#include <rastertrace/trace/tell/step_text.h>
#include <rastertrace/trace/text/json_scanner.h>

#include <algorithm>
#include <set>

namespace rastertrace {

namespace {

/// What stands between the parts of a key; no name holds it.
constexpr char between = '\0';

} // namespace

std::string normal_form(const std::string& value) {
    const auto number = number_in(value);
    return number ? number->get_str() : value;
}

StepIndex::StepIndex(const Trace& trace) : right_(StepContext(trace)) {}

std::size_t StepIndex::side_of(std::size_t n) const {
    // The edges of a fill come before its rows; a side before its own pixels.
    const auto edges = steps().at(n).edges();
    const bool is_side = !edges.empty() && trace().step(edges.back()).as<EdgeStep>().octant;
    return is_side ? edges.back() : 0;
}

std::vector<std::string> StepIndex::names_around(std::size_t n) const {
    std::vector<std::string> names;
    if (primitive_of(n) == 0)
        return names;
    std::string name = name_in(trace().step(primitive_of(n))).text();
    names.push_back(name);
    for (std::size_t slash; (slash = name.find_last_of('/')) != std::string::npos;) {
        name.resize(slash); // what ABC/1 is a part of
        names.push_back(name);
    }
    if (const std::size_t side = side_of(n); side != 0)
        names.push_back(trace().step(side).as<EdgeStep>().edge.text());
    return names;
}

namespace {

/// What a step says in a field; "" if it has none of that name.
std::string text_in(const StepView& step, std::string_view field) {
    return plain_text(step.field(field).value_or(""));
}

/// A value as it is compared in a field: numbers by what they are, names as they stand.
std::string compared(StepKind kind, std::string_view field, const std::string& value) {
    const auto& fields = fields_of(kind);
    const bool is_number = std::any_of(fields.begin(), fields.end(), [&](const StepField& one) {
        return one.name == field &&
               (one.type == FieldType::whole || one.type == FieldType::quantity);
    });
    return is_number ? normal_form(value) : value;
}

} // namespace

bool StepIndex::has_all(std::size_t n, StepKind kind, const Keys& wanted) const {
    const StepView step = trace().step(n);
    return std::all_of(wanted.begin(), wanted.end(), [&](const auto& key) {
        const auto& [field, value] = key;
        if (kind == StepKind::pixel && (field == "x" || field == "y"))
            return value == std::to_string((field == "x" ? x_in(step) : y_in(step)).value_or(0));
        if (field != "in")
            return compared(kind, field, text_in(step, field)) == value;
        const auto names = names_around(n);
        return std::find(names.begin(), names.end(), value) != names.end();
    });
}

const std::vector<std::size_t>& StepIndex::find(StepKind kind, const Keys& keys) const {
    // A table of so many steps fits into the memory; with more, all steps are gone through for each question.
    constexpr std::size_t most_in_table = 1'000'000;
    std::string fields;
    std::string wanted;
    Keys compared_keys;
    for (const auto& [field, value] : keys) {
        compared_keys.emplace_back(field, compared(kind, field, value));
        fields += field + between;
        wanted += compared_keys.back().second + between;
    }
    const auto [place, is_new] = found_.try_emplace({kind, fields});
    Found& found = place->second;
    if (steps().all_of(kind).size() > most_in_table) {
        const auto [asked, is_first] = found.try_emplace(wanted);
        if (is_first)
            for (const std::size_t n : steps().all_of(kind))
                if (has_all(n, kind, compared_keys))
                    asked->second.push_back(n);
        return asked->second;
    }
    static const std::vector<std::size_t> none;
    for (const std::size_t n : is_new ? steps().all_of(kind) : none) {
        std::vector<std::string> texts{""};
        for (const auto& [field, value] : keys) {
            const std::vector<std::string> values =
                field == "in" ? names_around(n)
                              : std::vector{compared(kind, field, text_in(trace().step(n), field))};
            std::vector<std::string> longer;
            for (const std::string& text : texts)
                for (const std::string& one : values)
                    longer.push_back(text + one + between);
            texts = std::move(longer);
        }
        for (const std::string& text : texts)
            found[text].push_back(n);
    }
    const auto steps = found.find(wanted);
    return steps == found.end() ? none : steps->second;
}

std::vector<std::string> StepIndex::values_of(StepKind kind, const std::string& field) const {
    find(kind, {{field, ""}}); // makes the table
    std::vector<std::string> values;
    for (const auto& [text, steps] : found_.at({kind, field + between}))
        values.push_back(text.substr(0, text.size() - 1));
    std::sort(values.begin(), values.end());
    return values;
}

const Frame& StepIndex::frame() const {
    if (!frame_)
        frame_.emplace(frame_after(trace(), trace().size()));
    return *frame_;
}

} // namespace rastertrace
