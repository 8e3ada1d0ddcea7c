// SPDX-License-Identifier: MIT
#include "positions.h"

#include <rastertrace/trace/tell/step_text.h>
#include <rastertrace/trace/text/json_scanner.h>

#include <cstddef>
#include <string_view>

namespace rastertrace {

namespace {

/// A number of a step as it is stored, if it is one.
std::optional<Coordinate> coordinate_in(std::string_view json, bool is_float) {
    if (const auto stored = stored_double_in(json, is_float))
        return Coordinate(*stored);
    const auto number = stored_number_in(json, is_float);
    return number ? std::optional(Coordinate(*number)) : std::nullopt;
}

/// The place that a point of a step stands for, if it is a pair of numbers.
std::optional<ScreenPoint> position_in(std::string_view json, bool is_float) {
    JsonScanner elements(json);
    const auto next_coordinate = [&] {
        return elements.next_element() ? coordinate_in(elements.value(), is_float) : std::nullopt;
    };
    const auto x = next_coordinate();
    const auto y = x ? next_coordinate() : std::nullopt;
    return y && !elements.next_element() ? std::optional(ScreenPoint{*x, *y}) : std::nullopt;
}

} // namespace

bool has_floats(const Trace& header) {
    return header.method_value("scalar") == "float";
}

std::optional<std::array<ScreenPoint, 3>> positions_in(const PrimitiveStep& step,
                                                       const Trace& header) {
    const bool is_float = has_floats(header);
    std::array<ScreenPoint, 3> found;
    std::size_t count = 0;
    JsonScanner places(step.at.json());
    while (places.next_element()) {
        const auto position = position_in(places.value(), is_float);
        if (!position || count == found.size())
            return std::nullopt;
        found[count++] = *position;
    }
    return count == found.size() ? std::optional(found) : std::nullopt;
}

} // namespace rastertrace
