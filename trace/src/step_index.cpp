// SPDX-License-Identifier: MIT
#include "step_index.h"

#include "step_text.h"

#include <algorithm>

namespace rastertrace {

namespace {

/// What stands between the parts of a key; no name holds it.
constexpr char between = '\0';

} // namespace

std::string normal_form(const std::string& value) {
    const auto number = number_in(value);
    return number ? number->get_str() : value;
}

StepIndex::StepIndex(const Trace& trace)
    : trace_(&trace), primitive_of_(trace.size() + 1), side_of_(trace.size() + 1) {
    std::uint32_t primitive = 0;
    std::uint32_t side = 0;
    for (std::size_t n = 1; n <= trace.size(); ++n) {
        const auto kind = trace.kind_of(n);
        if (kind == StepKind::primitive) {
            primitive = static_cast<std::uint32_t>(n);
            side = 0;
        }
        // The edges of a fill come before its rows; a side before its own pixels.
        if (kind == StepKind::edge && trace.step(n).field("octant"))
            side = static_cast<std::uint32_t>(n);
        primitive_of_[n] = primitive;
        side_of_[n] = side;
    }
}

std::vector<std::string> StepIndex::names_around(std::size_t n) const {
    std::vector<std::string> names;
    if (primitive_of(n) == 0)
        return names;
    std::string name = trace_->step(primitive_of(n)).text("name");
    names.push_back(name);
    for (std::size_t slash; (slash = name.find_last_of('/')) != std::string::npos;) {
        name.resize(slash); // what ABC/1 is a part of
        names.push_back(name);
    }
    if (side_of_[n] != 0)
        names.push_back(trace_->step(side_of_[n]).text("edge"));
    return names;
}

namespace {

/// A value as it is compared in a field: numbers by what they are, names as they stand.
std::string compared(StepKind kind, std::string_view field, const std::string& value) {
    const auto& fields = row_of(kind).fields;
    const bool is_number = std::any_of(fields.begin(), fields.end(), [&](const StepField& one) {
        return one.name == field &&
               (one.type == FieldType::whole || one.type == FieldType::quantity);
    });
    return is_number ? normal_form(value) : value;
}

} // namespace

const std::vector<std::size_t>& StepIndex::find(StepKind kind, const Keys& keys) const {
    std::string fields;
    std::string wanted;
    for (const auto& [field, value] : keys) {
        fields += field + between;
        wanted += compared(kind, field, value) + between;
    }
    const auto [place, is_new] = found_.try_emplace({kind, fields});
    Found& found = place->second;
    for (std::size_t n = 1; is_new && n <= trace_->size(); ++n) {
        if (trace_->kind_of(n) != kind)
            continue;
        std::vector<std::string> texts{""};
        for (const auto& [field, value] : keys) {
            const std::vector<std::string> values =
                field == "in" ? names_around(n)
                              : std::vector{compared(kind, field, trace_->step(n).text(field))};
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
    const auto& places = find(StepKind::vertex, {{"name", trace_->step(n).text("name")}});
    const auto here = std::lower_bound(places.begin(), places.end(), n);
    return here == places.begin() ? 0 : *(here - 1);
}

const Values& StepIndex::numbers(std::size_t step, std::string_view field) const {
    const auto [place, is_new] = numbers_.try_emplace({step, std::string(field)});
    Values& values = place->second;
    if (!is_new)
        return values;
    const StepView view = trace_->step(step);
    const bool is_list = view.field(field).value_or("").starts_with('[');
    for (const std::string& text : is_list ? view.texts(field) : std::vector{view.text(field)}) {
        const auto number = number_in(text);
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
