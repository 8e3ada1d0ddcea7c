// SPDX-License-Identifier: MIT
#include "diff_tally.h"

#include <algorithm>

namespace rastertrace {

KindDifference& DiffTally::of_kind(const KeyedStep& step) {
    KindDifference& kind = kinds_[step.kind_name];
    kind.kind = step.kind_name;
    return kind;
}

void DiffTally::add_changed(std::size_t gap, const KeyedStep& a, const KeyedStep& b,
                            std::vector<FieldDifference> fields) {
    KindDifference& kind = of_kind(a);
    ++kind.changed;
    for (const FieldDifference& field : fields) {
        auto summary =
            std::find_if(kind.fields.begin(), kind.fields.end(),
                         [&field](const FieldSummary& one) { return one.name == field.name; });
        if (summary == kind.fields.end())
            summary = kind.fields.insert(kind.fields.end(), {.name = field.name});
        ++summary->count;
        if (field.distance)
            summary->largest = std::max(summary->largest.value_or(0), *field.distance);
    }
    note_first(gap, &a, &b, std::move(fields), false);
}

void DiffTally::add_alone(std::size_t gap, bool is_in_a, const KeyedStep& step) {
    KindDifference& kind = of_kind(step);
    ++(is_in_a ? kind.only_a : kind.only_b);
    note_first(gap, is_in_a ? &step : nullptr, is_in_a ? nullptr : &step, {}, false);
}

void DiffTally::add_moved(std::size_t gap, const KeyedStep& a, const KeyedStep& b) {
    if (!counts_moved_)
        return;
    ++of_kind(a).moved;
    note_first(gap, &a, &b, {}, true);
}

void DiffTally::note_first(std::size_t gap, const KeyedStep* a, const KeyedStep* b,
                           std::vector<FieldDifference> fields, bool is_moved) {
    if (first_ && first_->gap < gap)
        return;
    if (first_ && first_->gap == gap) {
        const bool is_of_one = !first_->a || !first_->b;
        if (is_of_one && !first_->a && a != nullptr && b == nullptr)
            first_->a = *a;
        if (is_of_one && !first_->b && b != nullptr && a == nullptr)
            first_->b = *b;
        return;
    }
    first_ = FirstDifference{.gap = gap,
                             .a = a == nullptr ? std::nullopt : std::optional(*a),
                             .b = b == nullptr ? std::nullopt : std::optional(*b),
                             .fields = std::move(fields),
                             .is_moved = is_moved,
                             .section = section_};
}

std::vector<KindDifference> DiffTally::kinds() const {
    std::vector<KindDifference> sorted;
    for (const std::string_view name : step_kind_names())
        if (const auto found = kinds_.find(std::string(name)); found != kinds_.end())
            sorted.push_back(found->second);
    for (const auto& [name, kind] : kinds_)
        if (!step_kind_named(name))
            sorted.push_back(kind);
    return sorted;
}

} // namespace rastertrace
