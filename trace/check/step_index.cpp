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

StepIndex::StepIndex(const Trace& trace) : trace_(&trace) {
    for (std::size_t n = 1; n <= trace.size(); ++n) {
        const auto kind = trace.kind_of(n);
        if (!kind)
            continue;
        ++count_[static_cast<std::size_t>(*kind)];
        if (kind == StepKind::primitive)
            primitives_.push_back(n);
        // The edges of a fill come before its rows; a side before its own pixels.
        if (kind == StepKind::edge && trace.step(n).as<EdgeStep>().octant)
            sides_.push_back(n);
    }
}

std::size_t StepIndex::last_until(const std::vector<std::size_t>& steps, std::size_t n) {
    const auto behind = std::upper_bound(steps.begin(), steps.end(), n);
    return behind == steps.begin() ? 0 : *(behind - 1);
}

std::size_t StepIndex::side_of(std::size_t n) const {
    const std::size_t side = last_until(sides_, n);
    return side > primitive_of(n) ? side : 0;
}

std::vector<std::string> StepIndex::names_around(std::size_t n) const {
    std::vector<std::string> names;
    if (primitive_of(n) == 0)
        return names;
    std::string name = name_in(trace_->step(primitive_of(n))).text();
    names.push_back(name);
    for (std::size_t slash; (slash = name.find_last_of('/')) != std::string::npos;) {
        name.resize(slash); // what ABC/1 is a part of
        names.push_back(name);
    }
    if (const std::size_t side = side_of(n); side != 0)
        names.push_back(trace_->step(side).as<EdgeStep>().edge.text());
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
    const StepView step = trace_->step(n);
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
    if (count_[static_cast<std::size_t>(kind)] > most_in_table) {
        const auto [asked, is_first] = found.try_emplace(wanted);
        for (std::size_t n = 1; is_first && n <= trace_->size(); ++n)
            if (trace_->kind_of(n) == kind && has_all(n, kind, compared_keys))
                asked->second.push_back(n);
        return asked->second;
    }
    for (std::size_t n = 1; is_new && n <= trace_->size(); ++n) {
        if (trace_->kind_of(n) != kind)
            continue;
        std::vector<std::string> texts{""};
        for (const auto& [field, value] : keys) {
            const std::vector<std::string> values =
                field == "in" ? names_around(n)
                              : std::vector{compared(kind, field, text_in(trace_->step(n), field))};
            std::vector<std::string> longer;
            for (const std::string& text : texts)
                for (const std::string& one : values)
                    longer.push_back(text + one + between);
            texts = std::move(longer);
        }
        for (const std::string& text : texts)
            found[text].push_back(n);
    }
    static const std::vector<std::size_t> none;
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

std::size_t StepIndex::place(const std::string& vertex, std::string_view space) const {
    const auto& steps = find(StepKind::vertex, {{"name", vertex}, {"space", std::string(space)}});
    return steps.empty() ? 0 : steps.front();
}

std::size_t StepIndex::place_before(std::size_t n) const {
    const auto& places = find(StepKind::vertex, {{"name", name_in(trace_->step(n)).text()}});
    const auto here = std::lower_bound(places.begin(), places.end(), n);
    return here == places.begin() ? 0 : *(here - 1);
}

std::vector<std::size_t> StepIndex::pixels_of(std::size_t primitive) const {
    const Keys in{{"in", name_in(trace_->step(primitive)).text()}};
    std::vector<std::size_t> steps = find(StepKind::pixel, in);
    const auto& tests = find(StepKind::depth, in);
    steps.insert(steps.end(), tests.begin(), tests.end());
    std::sort(steps.begin(), steps.end());
    std::set<std::pair<Index, Index>> seen;
    std::erase_if(steps, [&](std::size_t n) {
        const StepView step = trace_->step(n);
        return !seen.emplace(y_in(step).value_or(0), x_in(step).value_or(0)).second;
    });
    return steps;
}

const Values& StepIndex::numbers(std::size_t step, std::string_view field) const {
    const auto [place, is_new] = numbers_.try_emplace({step, std::string(field)});
    Values& values = place->second;
    if (!is_new)
        return values;
    const StepView view = trace_->step(step);
    const auto json = view.field(field).value_or("");
    const TracedList<TracedNumber> list(json);
    for (const auto& one :
         json.starts_with('[') ? list.values() : std::vector{TracedNumber(json)}) {
        const auto number = one.exact();
        if (!number) {
            values.clear();
            break;
        }
        values.push_back(*number);
    }
    return values;
}

const Frame& StepIndex::frame() const {
    if (!frame_)
        frame_.emplace(frame_after(*trace_, trace_->size()));
    return *frame_;
}

} // namespace rastertrace
