// SPDX-License-Identifier: MIT
#include "numbers.h"

#include "derivation.h"

#include <rastertrace/trace/record/traced_steps.h>
#include <rastertrace/trace/tell/step_text.h>

#include <fmt/core.h>

namespace rastertrace {

std::string name_of_number(const StepIndex& index, std::size_t step, std::string_view field) {
    const StepView view = index.trace().step(step);
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
        const std::string name = name_of_number(*index_, step, field);
        if (const WrongNumber* claimed = replacement(name))
            return claimed->values;
        if (works_out_)
            if (const WorkedOut& again = worked_out(step, field, name); !again.values.empty()) {
                used_ = again.from;
                return again.values;
            }
    }
    return index_->numbers(step, field);
}

std::optional<Rational> Numbers::one(std::size_t step, std::string_view field) const {
    const Values values = of(step, field);
    return values.size() == 1 ? std::optional(values.front()) : std::nullopt;
}

std::optional<Vec<Rational, 2>> Numbers::corner(std::size_t primitive, std::size_t i) const {
    if (primitive == 0)
        return std::nullopt; // the trace leaves its primitives out
    const auto drawn = step(primitive).as<PrimitiveStep>();
    const auto names = drawn.vertices.texts();
    const auto places = drawn.at.values();
    if (i >= names.size() || i >= places.size())
        return std::nullopt;
    const std::size_t screen = index_->place(names[i], "screen");
    const bool is_snapped = screen != 0 && step(screen).as<VertexStep>().snapped;
    const Values at = of(screen, is_snapped ? "snapped" : "at");
    if (at.size() == 2)
        return Vec<Rational, 2>{at[0], at[1]};
    return vec2_in(places[i].texts());
}

std::optional<Vec<Rational, 3>> Numbers::in_world(const std::string& vertex) const {
    std::size_t step = index_->place(vertex, "world");
    if (step == 0)
        step = index_->place(vertex, "object"); // nothing has moved it
    const Values at = of(step, "at");
    return at.size() == 3 ? std::optional(Vec3{at[0], at[1], at[2]}) : std::nullopt;
}

} // namespace rastertrace
