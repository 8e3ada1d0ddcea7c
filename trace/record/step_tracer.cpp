// SPDX-License-Identifier: MIT
#include "step_tracer.h"

#include <rastertrace/trace/text/format_number.h>
#include <rastertrace/trace/text/primitive_name.h>
#include <rastertrace/trace/text/text.h>

#include <cmath>
#include <cstdint>
#include <limits>
#include <numeric>

namespace rastertrace {

void FieldTracer::begin(std::string_view name, std::span<const std::string_view> vertices) {
    if (!keeps_)
        own_.clear();
    name_ = quoted(name, of_primitive());
    vertices_.assign(vertices.begin(), vertices.end());
    labels_.assign(2 * vertices.size(), {});
}

/// The name of an edge of the current primitive: from each vertex there is the way to the next one, and back to the one
/// before.
TracedText FieldTracer::label(EdgeName edge) {
    const bool leads_on =
        edge.to == edge.from + 1 || (edge.to == 0 && edge.from + 1U == vertices_.size());
    const std::size_t number = 2U * edge.from + (leads_on ? 0 : 1);
    if (number >= labels_.size() || edge.to >= vertices_.size())
        return TracedText("\"\"");
    if (!labels_[number])
        labels_[number] = quoted(std::string(vertices_[edge.from])
                                     .append(name_separator(vertices_))
                                     .append(vertices_[edge.to]),
                                 of_primitive());
    return labels_[number];
}

TracedText FieldTracer::quoted(std::string_view name, Arena& arena) {
    const auto is_plain = [](char c) { return ' ' <= c && c <= '~' && c != '"' && c != '\\'; };
    if (std::all_of(name.begin(), name.end(), is_plain)) { // nearly always
        const std::span<char> room = arena.array<char>(name.size() + 2);
        room.front() = room.back() = '"';
        std::copy(name.begin(), name.end(), room.begin() + 1);
        return TracedText({room.data(), room.size()});
    }
    std::string text(room_for_quoted(name), '\0');
    const char* const end = write_quoted(text.data(), name);
    return TracedText(arena.copy({text.data(), static_cast<std::size_t>(end - text.data())}));
}

void FieldTracer::trace(TracedNumber& told, const Quantity& quantity) {
    told = quantity.visit([this]<typename Number>(const Number& number) {
        if constexpr (std::is_same_v<Number, Rational>) {
            return TracedNumber(arena_.copy("\"" + number.get_str() + "\""));
        } else if constexpr (std::is_floating_point_v<Number>) {
            if (!std::isfinite(number))
                refuse_to_format(static_cast<double>(number));
            return TracedNumber(number);
        } else {
            const Index divisor = std::gcd(number.numerator, number.denominator);
            const Index denominator = number.denominator / divisor;
            if (denominator <= std::numeric_limits<std::uint32_t>::max())
                return TracedNumber(number.numerator / divisor,
                                    static_cast<std::uint32_t>(denominator));
            std::array<char, room_for(Fraction64{})> text{};
            const char* const end = format_number(text.data(), number);
            return TracedNumber(
                arena_.copy({text.data(), static_cast<std::size_t>(end - text.data())}));
        }
    });
}

FilterOfSteps::FilterOfSteps(const StepFilter& filter)
    : region_(filter.region), primitive_(filter.primitive), is_in_primitive_(!filter.primitive) {
    kinds_.fill(!filter.only);
    if (filter.only)
        for (const StepKind kind : *filter.only)
            kinds_[static_cast<std::size_t>(kind)] = true;
}

void FilterOfSteps::begin(std::string_view name) {
    is_in_primitive_ =
        !primitive_ || (name.starts_with(*primitive_) && // ABC/1 is a part of ABC
                        (name.size() == primitive_->size() || name[primitive_->size()] == '/'));
}

bool FilterOfSteps::is_in_region(const PixelsRejected<>& step) const {
    const auto [low_y, high_y] = std::minmax({*step.y, step.to_y.value_or(*step.y)});
    if (high_y < region_->y0 || region_->y1 < low_y)
        return false;
    if (!step.x)
        return true;
    const auto [low_x, high_x] = std::minmax({*step.x, step.to_x.value_or(*step.x)});
    return region_->meets(low_x, high_x);
}

} // namespace rastertrace
