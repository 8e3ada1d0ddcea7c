// SPDX-License-Identifier: MIT
#include "positions.h"

#include <rastertrace/trace/tell/step_text.h>

#include <cstddef>

namespace rastertrace {

namespace {

/// A number of a step as it is stored, if it is one.
std::optional<Coordinate> coordinate_in(const TracedNumber& told, bool is_float) {
    if (const auto stored = told.stored_double(is_float))
        return Coordinate(*stored);
    const auto number = stored_number_in(told, is_float);
    return number ? std::optional(Coordinate(*number)) : std::nullopt;
}

/// The place that a point of a step stands for, if it is a pair of numbers.
std::optional<ScreenPoint> position_in(const TracedList<TracedNumber>& told, bool is_float) {
    const auto numbers = told.values();
    if (numbers.size() != 2)
        return std::nullopt;
    const auto x = coordinate_in(numbers[0], is_float);
    const auto y = coordinate_in(numbers[1], is_float);
    return x && y ? std::optional(ScreenPoint{*x, *y}) : std::nullopt;
}

} // namespace

std::optional<std::array<ScreenPoint, 3>> positions_in(const PrimitiveStep& step,
                                                       const Trace& header) {
    const bool is_float = header.method.has_floats();
    std::array<ScreenPoint, 3> found;
    const auto places = step.at.values();
    if (places.size() != found.size())
        return std::nullopt;
    for (std::size_t i = 0; i < found.size(); ++i) {
        const auto position = position_in(places[i], is_float);
        if (!position)
            return std::nullopt;
        found[i] = *position;
    }
    return found;
}

} // namespace rastertrace
