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

/// True if a trace writes both alike.
inline bool are_same(const StepView& a, const StepView& b) {
    if (a.kind() != b.kind())
        return false;
    if (!a.own_text().empty() || !b.own_text().empty())
        return a.json() == b.json();
    bool is_same = true;
    visit_step(a, [&]<typename Step>(const Step& of_a) {
        const Step& of_b = b.as<Step>();
        for_each_pair_of_fields(of_a, of_b, [&is_same](const auto& in_a, const auto& in_b) {
            is_same = is_same && in_a == in_b;
        });
    });
    return is_same;
}

} // namespace rastertrace
