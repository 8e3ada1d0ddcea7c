// SPDX-License-Identifier: MIT
#include "step_index.h"

#include "step_text.h"

#include <algorithm>

namespace rastertrace {

namespace {

/// What stands between the parts of a key; no name holds it.
constexpr char between = '\0';

/// The name of a step's primitive, and those of all that it is a part of: ABC/1, ABC.
std::vector<std::string> names_around(std::string name) {
    std::vector<std::string> names{name};
    for (std::size_t slash; (slash = name.find_last_of('/')) != std::string::npos;) {
        name.resize(slash);
        names.push_back(name);
    }
    return names;
}

} // namespace

std::string normal_form(const std::string& value) {
    const auto number = number_in(value);
    return number ? number->get_str() : value;
}

StepIndex::StepIndex(const Trace& trace) : trace_(&trace), primitive_of_(trace.size() + 1) {
    std::uint32_t primitive = 0;
    for (std::size_t n = 1; n <= trace.size(); ++n) {
        if (trace.kind_of(n) == StepKind::primitive)
            primitive = static_cast<std::uint32_t>(n);
        primitive_of_[n] = primitive;
    }
}

const std::vector<std::size_t>& StepIndex::find(StepKind kind, const Keys& keys) const {
    std::string fields;
    std::string wanted;
    for (const auto& [field, value] : keys) {
        fields += field + between;
        wanted += normal_form(value) + between;
    }
    const auto [place, is_new] = found_.try_emplace({kind, fields});
    Found& found = place->second;
    for (std::size_t n = 1; is_new && n <= trace_->size(); ++n) {
        if (trace_->kind_of(n) != kind)
            continue;
        std::vector<std::string> texts{""};
        for (const auto& [field, value] : keys) {
            const bool is_primitive = field == "in";
            const std::size_t owner = primitive_of(n);
            const std::vector<std::string> values =
                !is_primitive ? std::vector{normal_form(trace_->step(n).text(field))}
                : owner == 0  ? std::vector<std::string>{}
                              : names_around(trace_->step(owner).text("name"));
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

std::vector<std::size_t> StepIndex::decisions_on(const std::string& line) const {
    const auto& of_line = find(StepKind::decide, {{"in", line}});
    if (!of_line.empty())
        return of_line;
    // A side of an outline: the steps from its `edge` to the next one.
    std::vector<std::size_t> steps;
    const auto& sides = find(StepKind::edge, {{"edge", line}});
    for (std::size_t n = sides.empty() ? trace_->size() : sides.front(); ++n <= trace_->size();) {
        const auto kind = trace_->kind_of(n);
        if (kind == StepKind::edge || kind == StepKind::primitive)
            break;
        if (kind == StepKind::decide)
            steps.push_back(n);
    }
    return steps;
}

const Frame& StepIndex::frame() const {
    if (!frame_)
        frame_.emplace(frame_after(*trace_, trace_->size()));
    return *frame_;
}

} // namespace rastertrace
