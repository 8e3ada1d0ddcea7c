// SPDX-License-Identifier: MIT
#include "steps.h"

#include "step_decoder.h"

#include <rastertrace/trace/text/input.h>

#include <algorithm>
#include <utility>

namespace rastertrace {

void Steps::bound(std::size_t most_steps) {
    most_ = most_steps;
    most_bytes_ = most_held(most_steps, held_bytes_of_step);
    most_pixels_ = most_held(most_steps, held_pixels_of_step);
}

void Steps::count_value() {
    if (values_++ == most_)
        throw too_many_steps(source_.name, most_);
}

void Steps::add_entry(std::uint32_t code, std::size_t place) {
    constexpr std::size_t most = (std::size_t{1} << bits_of_place) - 1;
    if (place > most)
        throw too_many_steps(source_.name, most);
    if (arena_.bytes() > most_bytes_)
        throw too_much_to_hold(source_.name, most_bytes_, "bytes");
    order_.add(code << bits_of_place | static_cast<std::uint32_t>(place), arena_);
}

void Steps::take(const PixelStep& step) {
    constexpr Index most = 1 << 30; // a pixel off the canvas may lie anywhere
    const bool is_plain =
        !step.color && -most < step.x && step.x < most && -most < step.y && step.y < most;
    if (!is_plain) {
        count_value();
        return add(step);
    }
    const Pixel pixel{static_cast<int>(step.x), static_cast<int>(step.y)};
    const bool goes_on = size() > 0 && order_.back() >> bits_of_place == code_of_pixel_in_run &&
                         pixel_in_run(size() + 1, runs_.back()) == pixel;
    if (!goes_on) {
        count_value();
        runs_.add({pixel, size() + 1}, arena_);
    }
    add_entry(code_of_pixel_in_run, runs_.size() - 1);
    if (++pixels_in_runs_ > most_pixels_)
        throw too_much_to_hold(source_.name, most_pixels_, "pixels");
}

void Steps::take_text(std::optional<StepKind> kind, std::string_view json) {
    count_value();
    texts_.push_back({size() + 1, json});
    if (!kind)
        return add_entry(code_of_unknown, 0);
    std::visit([this](const auto& step) { add(step); }, step_in_text(json, *kind));
}

namespace {

template <typename Lists, std::size_t... kind>
const void* value_at(const Lists& lists, std::uint32_t code, std::size_t place,
                     std::index_sequence<kind...> /*all*/) {
    const void* value = nullptr;
    static_cast<void>(((kind == code && (value = &std::get<kind>(lists)[place], true)) || ...));
    return value;
}

template <typename Lists, std::size_t... kind>
std::size_t size_of(const Lists& lists, std::size_t code, std::index_sequence<kind...> /*all*/) {
    std::size_t size = 0;
    static_cast<void>(((kind == code && (size = std::get<kind>(lists).size(), true)) || ...));
    return size;
}

constexpr std::make_index_sequence<step_kinds> all_kinds;

} // namespace

StepView Steps::at(std::size_t n) const {
    const std::uint32_t code = order_[n - 1] >> bits_of_place;
    const std::size_t place = order_[n - 1] & ((std::uint32_t{1} << bits_of_place) - 1);
    if (code == code_of_pixel_in_run)
        return StepView(pixel_in_run(n, runs_[place]));
    if (code == code_of_unknown)
        return {std::nullopt, nullptr, text_of(n)};
    return {static_cast<StepKind>(code), value_at(lists_, code, place, all_kinds), text_of(n)};
}

std::string_view Steps::text_of(std::size_t n) const {
    const auto found =
        std::lower_bound(texts_.begin(), texts_.end(), n,
                         [](const TextOfStep& one, std::size_t step) { return one.step < step; });
    return found == texts_.end() || found->step != n ? std::string_view() : found->json;
}

KindCounts Steps::counts() const {
    KindCounts counts{};
    for (std::size_t kind = 0; kind < step_kinds; ++kind)
        counts[kind] = size_of(lists_, kind, all_kinds);
    counts[code_of(StepKind::pixel)] += pixels_in_runs_;
    return counts;
}

std::uint64_t Steps::count(std::string_view kind) const {
    if (const auto known = step_kind_named(kind))
        return counts()[code_of(*known)];
    return static_cast<std::uint64_t>(
        std::count_if(texts_.begin(), texts_.end(), [&](const TextOfStep& text) {
            return !this->kind(text.step) && at(text.step).kind_name() == kind;
        }));
}

} // namespace rastertrace
