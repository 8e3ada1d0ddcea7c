// SPDX-License-Identifier: MIT
#pragma once

// Something done with a step of whatever kind.
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

} // namespace rastertrace
