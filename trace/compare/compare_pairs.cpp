// SPDX-License-Identifier: MIT
// What TraceComparison does where the primitives are not the same in the same order: those that are the same are looked
// for, and compared wherever they stand.

#include "trace_comparison.h"

#include <rastertrace/trace/record/traced_steps.h>
#include <rastertrace/trace/tell/step_text.h>

#include <algorithm>
#include <functional>

namespace rastertrace {

namespace {

/// The primitives that are left of a trace, which is drawn meanwhile.
std::vector<PrimitivePlace> primitives_from_here(DiffSide& side) {
    std::vector<PrimitivePlace> primitives;
    for (; !side.steps.is_behind(); side.pass()) {
        const std::size_t n = side.steps.next();
        if (side.trace.kind_of(n) == StepKind::primitive && !side.tells_part(n)) {
            if (!primitives.empty())
                primitives.back().end = n;
            primitives.push_back(primitive_place(side.trace.step(n).as<PrimitiveStep>(), n));
        } else if (!primitives.empty()) {
            primitives.back().content = primitives.back().content * 31 +
                                        std::hash<std::string_view>()(side.trace.step(n).json());
        }
    }
    if (!primitives.empty())
        primitives.back().end = side.steps.next();
    return primitives;
}

} // namespace

void TraceComparison::compare_pairs() {
    const std::vector<PrimitivePlace> of_a = primitives_from_here(a_);
    const std::vector<PrimitivePlace> of_b = primitives_from_here(b_);
    const PrimitivePairs pairs = pair_primitives(of_a, of_b);
    const std::vector<std::size_t>& in_b = pairs.in_b;
    const std::vector<std::size_t>& in_a = pairs.in_a;
    const std::vector<bool> stays = in_common_order(in_b);
    for (const std::size_t place : in_b)
        partner_.push_back(
            place == nowhere ? 0 : common_primitives_ + static_cast<std::uint32_t>(place) + 1);
    const bool is_one_order = std::find(stays.begin(), stays.end(), false) == stays.end() &&
                              std::find(in_a.begin(), in_a.end(), nowhere) == in_a.end();
    if (!is_one_order && compared_.tells_all_primitives())
        remarks_.push_back(said("the primitives are not the same in the same order: from there "
                                "on the traces were read twice"));

    // Both lists together: what only one has, what has moved, and what is in the same order in both.
    const auto is_broken = [&](std::size_t in_list_a, std::size_t in_list_b) {
        return (in_list_a + 1 == of_a.size() && a_.breaks_off) ||
               (in_list_b + 1 == of_b.size() && b_.breaks_off);
    };
    std::size_t i = 0;
    std::size_t j = 0;
    while (i < of_a.size() || j < of_b.size()) {
        ++gap_;
        if (i < of_a.size() && in_b[i] == nowhere) {
            if (!b_.breaks_off)
                add_primitive(a_, of_a[i]);
            ++i;
        } else if (j < of_b.size() && in_a[j] == nowhere) {
            if (!a_.breaks_off)
                add_primitive(b_, of_b[j]);
            ++j;
        } else if (i < of_a.size() && !stays[i]) {
            compare_primitives(of_a[i], of_b[in_b[i]], true, is_broken(i, in_b[i]));
            ++i;
        } else if (j < of_b.size() && !stays[in_a[j]]) {
            ++j; // it has moved: it is compared where a has it
        } else {
            compare_primitives(of_a[i], of_b[j], false, is_broken(i, j));
            ++i;
            ++j;
        }
    }
}

/// A primitive that only one trace has, with all its steps.
void TraceComparison::add_primitive(const DiffSide& side, const PrimitivePlace& primitive) {
    if (!compared_.has_primitive(primitive.name))
        return;
    DiffSection section;
    (side.is_a ? section.a : section.b) = primitive.begin;
    tally_.begin_section(section);
    StepsAhead steps(side.trace, primitive.begin, primitive.end - 1, options_.keys);
    for (; const KeyedStep* const step = steps.front(); steps.pass())
        if (compared_.has(*step))
            tally_.add_alone(gap_, side.is_a, *step);
}

/// A primitive that both traces have, perhaps at another place.
void TraceComparison::compare_primitives(const PrimitivePlace& of_a, const PrimitivePlace& of_b,
                                         bool has_moved, bool breaks_off) {
    DiffSide a(a_, of_a, breaks_off, options_.keys);
    DiffSide b(b_, of_b, breaks_off, options_.keys);
    a_.primitive_step = of_a.begin;
    b_.primitive_step = of_b.begin;
    if (const KeyedStep* const step = a.steps.front(); has_moved && compared_.has(*step)) {
        begin_section();
        tally_.add_moved(gap_, *step, *b.steps.front());
    }
    begin_primitive(a, b);
    compare_section(a, b);
}

} // namespace rastertrace
