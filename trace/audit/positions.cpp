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

/// The same of three points, if they stand there as rastertrace writes them: without blanks, and each number a double.
std::optional<std::array<ScreenPoint, 3>> plain_positions_in(std::string_view json, bool is_float) {
    std::array<ScreenPoint, 3> points;
    const auto take = [&json](std::string_view token) {
        const bool is_there = json.starts_with(token);
        json.remove_prefix(is_there ? token.size() : 0);
        return is_there;
    };
    const auto take_number = [&](Coordinate& into) {
        std::size_t size = 0;
        while (size < json.size() && json[size] != ',' && json[size] != ']')
            ++size;
        const std::string_view number = json.substr(0, size);
        const auto stored = stored_double_in(number, is_float);
        json.remove_prefix(number.size());
        into = Coordinate(stored.value_or(0));
        return stored.has_value();
    };
    for (std::size_t i = 0; i < points.size(); ++i)
        if (!take(i == 0 ? "[[" : ",[") || !take_number(points[i].x) || !take(",") ||
            !take_number(points[i].y) || !take("]"))
            return std::nullopt;
    return json == "]" ? std::optional(points) : std::nullopt;
}

} // namespace

bool has_floats(const Trace& header) {
    return header.method_value("scalar") == "float";
}

std::optional<std::array<ScreenPoint, 3>> positions_in(const PrimitiveStep& step,
                                                       const Trace& header) {
    const bool is_float = has_floats(header);
    if (const auto plain = plain_positions_in(step.at.json(), is_float))
        return plain;
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
