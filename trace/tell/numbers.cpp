// SPDX-License-Identifier: MIT
#include "numbers.h"

#include "formulas_of.h"

#include <rastertrace/trace/record/traced_steps.h>

#include <fmt/core.h>

#include <utility>

namespace rastertrace {

std::string name_of_number(const Trace& trace, std::size_t step, std::string_view field) {
    const StepView view = trace.step(step);
    switch (view.kind().value_or(StepKind::primitive)) {
    case StepKind::vertex: {
        const auto vertex = view.as<VertexStep>();
        return fmt::format("vertex {} {}", vertex.name.text(),
                           field == "snapped" ? field : vertex.space.text());
    }
    case StepKind::face:
    case StepKind::light:
        return fmt::format("{} {} {}", view.kind_name(), name_in(view).text(), field);
    default:
        return fmt::format("{} of step {}", field, step);
    }
}

/// What a field says, as numbers; nothing if it holds anything else.
const Values& Numbers::told(std::size_t step, std::string_view field) const {
    const auto [place, is_new] = told_.try_emplace({step, std::string(field)});
    Values& values = place->second;
    if (!is_new)
        return values;
    const auto json = this->step(step).field(field).value_or("");
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

const WrongNumber* Numbers::replacement(const std::string& name) const {
    if (wrong_ == nullptr)
        return nullptr;
    const auto found = wrong_->find(name);
    if (found == wrong_->end() || found->second.order > last_order_)
        return nullptr;
    used_ = &found->second;
    return used_;
}

const Numbers::WorkedOut& Numbers::worked_out(std::size_t step, std::string_view field,
                                              const std::string& name) const {
    const auto [place, is_new] = worked_out_.try_emplace(name);
    WorkedOut& result = place->second;
    if (!is_new)
        return result;
    const WrongNumber* const used_before = std::exchange(used_, nullptr);
    const auto formulas = formulas_of(*this, step, field);
    if (used_ != nullptr && !formulas.empty())
        result = {value_of(formulas.front()), used_};
    used_ = used_before;
    return result;
}

Values Numbers::of(std::size_t step, std::string_view field) const {
    if (step == 0)
        return {};
    if (wrong_ != nullptr && !wrong_->empty()) {
        const std::string name = name_of_number(trace(), step, field);
        if (const WrongNumber* claimed = replacement(name))
            return claimed->values;
        if (works_out_)
            if (const WorkedOut& again = worked_out(step, field, name); !again.values.empty()) {
                used_ = again.from;
                return again.values;
            }
    }
    return right().told(step, field);
}

std::optional<Rational> Numbers::one(std::size_t step, std::string_view field) const {
    const Values values = of(step, field);
    return values.size() == 1 ? std::optional(values.front()) : std::nullopt;
}

std::optional<Vec2> Numbers::corner(const PrimitiveText& primitive, std::size_t i) const {
    if (i >= primitive.vertices.size() || i >= primitive.positions.size())
        return std::nullopt;
    if (wrong_ != nullptr)
        for (const std::size_t n : steps_.places_of(primitive.vertices[i]))
            if (const auto vertex = step(n).as<VertexStep>(); vertex.space == Space::screen) {
                const std::string_view field = vertex.snapped ? "snapped" : "at";
                const Values at = of(n, field);
                if (at.size() == 2 && at != right().of(n, field))
                    return Vec2{at[0], at[1]};
                break;
            }
    return vec2_in(primitive.positions[i]);
}

std::optional<Vec3> Numbers::place_in(const std::string& vertex, Space space) const {
    std::size_t last = 0;
    for (const std::size_t n : steps_.places_of(vertex))
        for (const Space one : {Space::object, Space::world, Space::camera})
            if (one <= space && step(n).as<VertexStep>().space == one)
                last = n;
    const Values at = of(last, "at");
    return at.size() == 3 ? std::optional(Vec3{at[0], at[1], at[2]}) : std::nullopt;
}

std::optional<std::vector<Vec3>> Numbers::corners_in(const std::vector<std::string>& names,
                                                     Space space) const {
    std::vector<Vec3> corners;
    for (const std::string& name : names) {
        const auto corner = place_in(name, space);
        if (!corner)
            return std::nullopt;
        corners.push_back(*corner);
    }
    return corners.size() < 3 ? std::nullopt : std::optional(std::move(corners));
}

} // namespace rastertrace
