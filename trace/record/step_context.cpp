// SPDX-License-Identifier: MIT
#include "step_context.h"

#include <algorithm>
#include <iterator>

namespace rastertrace {

namespace {

/// Of steps in order, those behind step `first` and up to step `last`.
std::span<const std::size_t> between(const std::vector<std::size_t>& steps, std::size_t first,
                                     std::size_t last) {
    const auto begin = std::upper_bound(steps.begin(), steps.end(), first);
    const auto end = std::upper_bound(begin, steps.end(), last);
    return std::span(steps).subspan(static_cast<std::size_t>(begin - steps.begin()),
                                    static_cast<std::size_t>(end - begin));
}

/// The last but `behind` of these; 0 for none.
std::size_t last_of(std::span<const std::size_t> steps, std::size_t behind = 0) {
    return steps.size() <= behind ? 0 : steps[steps.size() - 1 - behind];
}

} // namespace

StepContext::StepContext(const Trace& trace, std::size_t step)
    : step_(step), trace_(&trace), lists_(std::make_shared<Lists>()) {}

StepContext StepContext::at(std::size_t step) const {
    StepContext other = *this;
    other.step_ = step;
    return other;
}

const std::vector<std::size_t>& StepContext::all_of(StepKind kind) const {
    const auto [all, is_new] = lists_->of_kind.try_emplace(kind);
    if (is_new)
        all->second = trace_->steps_of({kind});
    return all->second;
}

std::span<const std::size_t> StepContext::so_far(StepKind kind) const {
    return between(all_of(kind), 0, step_);
}

std::span<const std::size_t> StepContext::of_primitive_so_far(StepKind kind) const {
    return between(all_of(kind), primitive(), step_);
}

std::span<const std::size_t> StepContext::in_primitive(StepKind kind) const {
    const std::vector<std::size_t>& primitives = all_of(StepKind::primitive);
    const auto next = std::upper_bound(primitives.begin(), primitives.end(), step_);
    return between(all_of(kind), next == primitives.begin() ? 0 : *std::prev(next),
                   next == primitives.end() ? trace_->size() : *next - 1);
}

std::size_t StepContext::scanline() const {
    return last_of(of_primitive_so_far(StepKind::scanline));
}

std::size_t StepContext::scanline_before() const {
    return last_of(of_primitive_so_far(StepKind::scanline), 1);
}

std::size_t StepContext::ray() const {
    const std::size_t ray = last_of(of_primitive_so_far(StepKind::ray));
    return ray < last_of(edges()) ? 0 : ray;
}

std::size_t StepContext::order() const {
    return last_of(so_far(StepKind::order));
}

std::size_t StepContext::vertex_before() const {
    return last_of(so_far(StepKind::vertex), 1);
}

std::span<const std::size_t> StepContext::edges() const {
    return of_primitive_so_far(StepKind::edge);
}

std::size_t StepContext::primitive_of(std::size_t step) const {
    return last_of(between(all_of(StepKind::primitive), 0, step));
}

const std::vector<std::size_t>& StepContext::places_of(const std::string& vertex) const {
    auto& places = lists_->places;
    if (!places) {
        places.emplace();
        for (const std::size_t n : all_of(StepKind::vertex))
            (*places)[trace_->step(n).as<VertexStep>().name.text()].push_back(n);
    }
    static const std::vector<std::size_t> none;
    const auto found = places->find(vertex);
    return found == places->end() ? none : found->second;
}

} // namespace rastertrace
