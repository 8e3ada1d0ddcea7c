// SPDX-License-Identifier: MIT
#include "frames/off_canvas.h"

#include <rastertrace/trace/record/traced_steps.h>
#include <rastertrace/trace/tell/corners.h>

#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string_view>
#include <vector>

namespace rastertrace {

namespace {

/// In the order of `side_names`.
enum class Side : std::uint8_t { above, below, left, right };
constexpr std::size_t sides = 4;
constexpr std::array<std::string_view, sides> side_names{"above", "below", "left of", "right of"};

/// In the order of `unit_names`.
enum class Unit : std::uint8_t { triangle, row, pixel };
constexpr std::size_t units = 3;
constexpr std::array<std::string_view, units> unit_names{"triangle", "row", "pixel"};

/// How many of each unit lie on a side.
using Dropped = std::array<std::uint64_t, units>;

/// The side on which all of some points lie, if there is one.
std::optional<Side> side_of(const Canvas& canvas, const Path& points) {
    const auto all = [&points](auto&& is_there) {
        return !points.empty() && std::all_of(points.begin(), points.end(), is_there);
    };
    const auto row_of = [&canvas](const Place& point) {
        return (point.y - canvas.top()) * canvas.down();
    };
    if (all([&](const Place& point) { return row_of(point) < 0; }))
        return Side::above;
    if (all([&](const Place& point) { return row_of(point) > canvas.height - 1; }))
        return Side::below;
    if (all([&](const Place& point) { return point.x < canvas.left(); }))
        return Side::left;
    if (all([&](const Place& point) { return point.x > canvas.right(); }))
        return Side::right;
    return std::nullopt;
}

/// Counts what a reject step dropped: whole rows, or a run of pixels, which has one for each step
/// along its longer direction.
void count_rejected(const RejectStep& reject, const Canvas& canvas,
                    std::array<Dropped, sides>& dropped) {
    if (!reject.y || reject.why != "off-canvas")
        return;
    const bool is_row = !reject.x;
    const Index y = *reject.y;
    const Index to_y = reject.to_y.value_or(y);
    const Index x = reject.x.value_or(0);
    const Index to_x = reject.to_x.value_or(x);
    const auto point = [&](Index px, Index py) {
        // A row is beside no canvas.
        return Place{static_cast<double>(is_row ? canvas.left() : px), static_cast<double>(py)};
    };
    const Place first = point(x, y);
    auto side = side_of(canvas, {first, point(to_x, to_y)});
    if (!side) // around a corner
        side = side_of(canvas, {first});
    if (!side)
        return;
    const Index across = is_row ? 0 : std::abs(to_x - x);
    dropped[static_cast<std::size_t>(*side)]
           [static_cast<std::size_t>(is_row ? Unit::row : Unit::pixel)] +=
        static_cast<std::uint64_t>(std::max(across, std::abs(to_y - y)) + 1);
}

/// "3 rows and 2 pixels".
std::string in_words(const Dropped& dropped) {
    std::string text;
    for (std::size_t unit = 0; unit < units; ++unit)
        if (const std::uint64_t count = dropped[unit]; count > 0)
            text += fmt::format("{}{} {}{}", text.empty() ? "" : " and ", count, unit_names[unit],
                                count == 1 ? "" : "s");
    return text;
}

/// What one would ask where the vertices seem to be meant for a canvas of another origin: those of a center
/// have negative y, and those of a corner have none. What is too large either way raises no question.
std::string_view origin_question(const Canvas& canvas, const std::array<Dropped, sides>& dropped) {
    const auto is_there = [&dropped](Side side) {
        return dropped[static_cast<std::size_t>(side)] != Dropped{};
    };
    if (is_there(Side::above) == is_there(Side::below))
        return "";
    switch (canvas.origin) {
    case Origin::top_left:
        return is_there(Side::above) ? R"(: does y point up? ("origin": "center"))" : "";
    case Origin::bottom_left:
        return is_there(Side::below) ? R"(: is the origin in the middle? ("origin": "center"))"
                                     : "";
    case Origin::center:
        break;
    }
    return is_there(Side::above) && !is_there(Side::left)
               ? R"(: does y point down? ("origin": "top-left"))"
               : "";
}

} // namespace

std::string off_canvas_text(const Trace& trace) {
    // How much, on which side.
    const Canvas& canvas = trace.canvas;
    std::array<Dropped, sides> dropped{};
    std::size_t primitive = 0;
    bool is_moved = false;
    for (std::size_t n = 1; n <= trace.size(); ++n) {
        const auto kind = trace.kind_of(n);
        if (kind == StepKind::primitive)
            primitive = n;
        is_moved = is_moved || kind == StepKind::matrix;
        if (kind == StepKind::reject)
            count_rejected(trace.step(n).as<RejectStep>(), canvas, dropped);
        if (kind == StepKind::skip && primitive != 0 &&
            trace.step(n).as<SkipStep>().why == SkipReason::off_canvas)
            if (const auto side =
                    side_of(canvas, corners_of(trace.step(primitive).as<PrimitiveStep>())))
                ++dropped[static_cast<std::size_t>(*side)]
                         [static_cast<std::size_t>(Unit::triangle)];
    }

    // The sentence: the verb and the noun stand behind the first side.
    std::string text;
    for (std::size_t side = 0; side < sides; ++side) {
        const std::string what = in_words(dropped[side]);
        if (what.empty())
            continue;
        const bool is_one = what.starts_with("1 ") && what.find(" and ") == std::string::npos;
        text += text.empty() ? fmt::format("{} {} {} the canvas", what, is_one ? "lies" : "lie",
                                           side_names[side])
                             : fmt::format(", {} {} it", what, side_names[side]);
    }
    if (text.empty())
        return text;
    text += ", none drawn";

    if (!is_moved)
        text += origin_question(canvas, dropped);
    return text + "\n";
}

} // namespace rastertrace
