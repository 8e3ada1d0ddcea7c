// SPDX-License-Identifier: MIT
#pragma once

// Something done with a step of whatever kind, and two steps compared.
//
//     visit_step(trace.step(n), [](const auto& step) { use(step.step_kind); });

#include "trace.h"
#include "traced_steps.h"

#include <cstddef>
#include <utility>
#include <variant>

namespace rastertrace {

template <typename Use, std::size_t... kind>
void visit_step(const StepView& step, const Use& use, std::index_sequence<kind...> /*all*/) {
    const auto its = static_cast<std::size_t>(*step.kind());
    static_cast<void>((
        (kind == its && (use(step.as<std::variant_alternative_t<kind, AnyStep>>()), true)) || ...));
}

/// Calls `use` with the struct of a step; not with that of a kind that we do not know.
template <typename Use> void visit_step(const StepView& step, const Use& use) {
    if (step.kind())
        visit_step(step, use, std::make_index_sequence<step_kinds>{});
}

template <typename Step, typename... Rows>
bool have_same_fields(const Step& a, const Step& b, FieldTable<Rows...> /*table*/) {
    return ((Rows::in(a) == Rows::in(b)) && ...);
}

/// True if a trace writes both alike.
inline bool are_same(const StepView& a, const StepView& b) {
    if (a.kind() != b.kind())
        return false;
    if (!a.own_text().empty() || !b.own_text().empty())
        return a.json() == b.json();
    bool are_same = true;
    visit_step(a, [&]<typename Step>(const Step& of_a) {
        are_same = have_same_fields(of_a, b.as<Step>(), typename Step::Fields{});
    });
    return are_same;
}

} // namespace rastertrace
