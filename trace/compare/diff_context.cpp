// SPDX-License-Identifier: MIT
#include "diff_context.h"

#include <rastertrace/trace/record/replay.h>
#include <rastertrace/trace/record/traced_steps.h>
#include <rastertrace/trace/tell/describe.h>

#include <algorithm>
#include <cstddef>
#include <optional>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

namespace rastertrace {

namespace {

/// So many steps are told before and behind the one that differs.
constexpr std::size_t steps_around = 1;

/// Where something is in a trace: a step, or what stands where it would be.
struct Spot {
    std::size_t number = 0;
    bool is_step = false;
};

/// The steps before it, the step, those after it.
using Around = std::tuple<std::vector<DiffStep>, std::optional<DiffStep>, std::vector<DiffStep>>;

Around around(const Trace& trace, const Spot& spot) {
    Around found;
    auto& [before, here, after] = found;
    Replay replay(trace, {.depths = true});
    const std::size_t first = spot.number - std::min(spot.number - 1, steps_around);
    const std::size_t last = spot.number + steps_around - (spot.is_step ? 0 : 1);
    for (std::size_t n = first; n <= std::min(last, trace.size()); ++n) {
        replay.go_to(n);
        DiffStep step{.number = n,
                      .line = trace.line_of(n),
                      .json = std::string(trace.step(n).json()),
                      .sentence = describe_step(replay)};
        if (n < spot.number)
            before.push_back(std::move(step));
        else if (n == spot.number && spot.is_step)
            here = std::move(step);
        else
            after.push_back(std::move(step));
    }
    return found;
}

/// Where a side's step is, or else where the comparison was.
std::optional<Spot> spot_of(const std::optional<KeyedStep>& step,
                            const std::optional<std::size_t>& place) {
    if (step)
        return Spot{step->number, true};
    return place ? std::optional(Spot{*place, false}) : std::nullopt;
}

} // namespace

void tell_first(TraceDiff& found, const TraceComparison& comparison, const Trace& a,
                const Trace& b) {
    const auto& first = comparison.tally().first();
    if (!first)
        return;
    const auto& gap = comparison.first_gap();
    const bool is_here = gap && gap->number == first->gap;
    StepDifference difference{.kind = first->a ? first->a->kind_name : first->b->kind_name,
                              .fields = first->fields,
                              .is_moved = first->is_moved};
    difference.primitive =
        first->a ? owner_in(a, first->section.a).name : owner_in(b, first->section.b).name;
    if (const auto spot = spot_of(first->a, is_here ? std::optional(gap->a) : std::nullopt))
        std::tie(found.before_a, difference.a, found.after_a) = around(a, *spot);
    if (const auto spot = spot_of(first->b, is_here ? std::optional(gap->b) : std::nullopt))
        std::tie(found.before_b, difference.b, found.after_b) = around(b, *spot);
    found.first = std::move(difference);
}

} // namespace rastertrace
