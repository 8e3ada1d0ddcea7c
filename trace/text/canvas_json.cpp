// SPDX-License-Identifier: MIT
#include "canvas_json.h"

#include "json_reader.h"
#include "text.h"

#include <rastertrace/core/numbers/number.h>

#include <fmt/core.h>

#include <cstddef>
#include <cstdint>
#include <utility>
#include <variant>
#include <vector>

namespace rastertrace {

namespace {

constexpr auto origins = std::to_array<std::string_view>({"center", "bottom-left", "top-left"});

/// The whole number from 1 to the largest side that a value is, if it is one.
std::optional<int> side_in(const JsonValue& value) {
    if (value.kind != JsonValue::Kind::number)
        return std::nullopt;
    const auto parsed = parse_number(value.text);
    const auto* number = std::get_if<Number>(&parsed);
    const auto side = number != nullptr ? number->numerator_over(1) : std::nullopt;
    if (!side || *side < 1 || *side > largest_canvas_side)
        return std::nullopt;
    return static_cast<int>(*side);
}

} // namespace

std::string_view name_of(Origin origin) {
    return origins[static_cast<std::size_t>(origin)];
}

std::span<const std::string_view> origin_words() {
    return origins;
}

std::optional<std::string> fault_of_size(const Canvas& canvas) {
    if (std::int64_t{canvas.width} * canvas.height <= largest_canvas_area)
        return std::nullopt;
    return fmt::format("expected a canvas of at most {} pixels, found {} x {}", largest_canvas_area,
                       canvas.width, canvas.height);
}

Result<CanvasJson> read_canvas_json(const Source& source, const JsonValue& value) {
    const auto expecting = [&source](const JsonValue& found, std::string_view expected) {
        return problem_at(source, found.begin,
                          fmt::format("expected {}, found {}", expected, described(found)));
    };
    if (value.kind != JsonValue::Kind::object)
        return expecting(value, R"(a canvas, like {"width": 17, "height": 14})");

    CanvasJson canvas;
    for (const auto& [key, item] : value.members()) {
        if (key.text == "width" || key.text == "height") {
            const auto side = side_in(item);
            if (!side)
                return expecting(item, fmt::format("a whole number of pixels from 1 to {}",
                                                   largest_canvas_side));
            (key.text == "width" ? canvas.width : canvas.height) = *side;
            (key.text == "width" ? canvas.has_width : canvas.has_height) = true;
        } else if (key.text == "origin") {
            bool known = false;
            for (std::size_t i = 0; i < origins.size(); ++i)
                if (item.kind == JsonValue::Kind::string && item.text == origins[i]) {
                    canvas.origin = static_cast<Origin>(i);
                    known = true;
                }
            if (!known)
                return expecting(item, fmt::format("one of {}", joined(origins, ", ")));
        } else {
            const std::vector<std::string_view> known(canvas_keys.begin(), canvas_keys.end());
            Problem problem = expecting(key, fmt::format("a key out of {}", joined(known, ", ")));
            problem.hint = hint_for_key(key.text, known);
            return problem;
        }
    }
    return canvas;
}

} // namespace rastertrace
