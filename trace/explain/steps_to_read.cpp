// SPDX-License-Identifier: MIT
// Which steps tell of a pixel and of the primitives nearest to it.

#include "pixel_units.h"

#include <rastertrace/trace/record/told_samples.h>
#include <rastertrace/trace/record/traced_steps.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <set>
#include <span>

namespace rastertrace {

namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

/// How far away a unit is, at least and at most.
struct Reach {
    double least = -infinity; ///< not above 0: only its steps tell; infinite: it has no distance
    double most = infinity;
};

/// A pixel, in the units' numbers.
struct PixelPlace {
    Pixel pixel;
    int column;
    int row;
    double x; ///< its sample
    double y;
};

/// Numbers of this size were rounded to floats, and worked with.
double rounded_by(double size) {
    constexpr double share = 0x1p-21;
    return share * size + 1e-9;
}

Reach reach_of(const PixelUnit& unit, const PixelPlace& at) {
    const auto& v = unit.values;
    const auto lies_in = [](const std::array<std::int16_t, 2>& range, int place) {
        return range[0] <= place && place <= range[1];
    };
    if (unit.rule == UnitRule::ask ||
        (lies_in(unit.columns, at.column) && lies_in(unit.rows, at.row)))
        return {};
    const auto beyond = [](double place, double low, double high) {
        const double distance = std::max(low - place, place - high);
        const double error = rounded_by(std::abs(place) + std::abs(low) + std::abs(high));
        return Reach{distance - error, distance + error};
    };
    switch (unit.rule) {
    case UnitRule::nothing:
        return {.least = infinity};
    case UnitRule::edges: {
        Reach reach{.most = -infinity};
        for (std::size_t i = 0; i < v.size(); i += 3) {
            const double along_x = double{v[i]} * at.x;
            const double along_y = double{v[i + 1]} * at.y;
            const double distance = -(along_x + along_y + double{v[i + 2]});
            const double error =
                rounded_by(std::abs(along_x) + std::abs(along_y) + std::abs(double{v[i + 2]}));
            reach.least = std::max(reach.least, distance - error);
            reach.most = std::max(reach.most, distance + error);
        }
        return reach;
    }
    case UnitRule::rows: {
        const double y = at.pixel.y;
        const double x = at.pixel.x;
        if (y < double{v[0]} || double{v[1]} < y)
            return beyond(at.y, double{v[4]}, double{v[5]});
        constexpr double from_end = 4; // from the end of a row to its last pixel, and its sample
        return {std::max(double{v[2]} - x, x - double{v[3]}) - from_end,
                std::max(std::abs(x - double{v[2]}), std::abs(x - double{v[3]})) + from_end};
    }
    default: {
        const Reach in_x = beyond(at.x, double{v[0]}, double{v[1]});
        const Reach in_y = beyond(at.y, double{v[2]}, double{v[3]});
        return {std::max(in_x.least, in_y.least), std::max(in_x.most, in_y.most)};
    }
    }
}

/// What is chosen from: parts of an index, or of a trace that was gone through.
struct Choice {
    std::span<const PixelUnit> units;
    std::array<std::uint64_t, far_reasons> others;
    std::span<const std::uint32_t> primitives;
    std::span<const std::uint32_t> loose;
};

/// The steps and, of `vertices`, the names whose `vertex` steps are needed with them.
std::optional<StepsToRead> chosen_steps(const Trace& trace, const Choice& from, Pixel pixel,
                                        std::size_t nearest, std::set<std::string>& vertices) {
    const auto& offset = told_samples(trace).triangles;
    const PixelPlace at{.pixel = pixel,
                        .column = pixel.x - trace.canvas.left(),
                        .row = static_cast<int>(trace.canvas.row_of(pixel.y)),
                        .x = nearest_double(offset.x_of(pixel.x)),
                        .y = nearest_double(offset.y_of(pixel.y))};
    const auto& [units, all_others, primitives, loose] = from;
    std::vector<double> least;
    std::vector<double> most;
    least.reserve(units.size());
    most.reserve(units.size());
    for (const PixelUnit& unit : units) {
        const Reach reach = reach_of(unit, at);
        least.push_back(reach.least);
        if (reach.least > 0 && reach.least < infinity)
            most.push_back(reach.most);
    }
    if (most.size() <= nearest)
        return std::nullopt;
    // No other one is among the nearest.
    std::nth_element(most.begin(), most.begin() + static_cast<std::ptrdiff_t>(nearest) - 1,
                     most.end());
    const double far = most[nearest - 1];

    StepsToRead chosen;
    std::array<std::uint64_t, far_reasons> others = all_others;
    auto& steps = chosen.steps;
    steps.assign(loose.begin(), loose.end());
    for (std::size_t i = 0, end = 0; i < units.size(); i = end) {
        end = i + 1;
        while (end < units.size() && units[end].is_part)
            ++end;
        const bool is_near = std::any_of(least.begin() + static_cast<std::ptrdiff_t>(i),
                                         least.begin() + static_cast<std::ptrdiff_t>(end),
                                         [far](double distance) { return distance <= far; });
        if (!is_near) {
            for (std::size_t unit = i; unit < end; ++unit)
                ++others[static_cast<std::size_t>(units[unit].reason)];
            continue;
        }
        const auto next =
            std::upper_bound(primitives.begin(), primitives.end(), units[end - 1].first);
        const std::size_t behind = next == primitives.end() ? trace.size() + 1 : *next;
        for (std::size_t n = units[i].first; n < behind; ++n) {
            steps.push_back(n);
            if (trace.kind_of(n) == StepKind::primitive)
                for (std::string& name : trace.step(n).as<PrimitiveStep>().vertices.texts())
                    vertices.insert(std::move(name));
        }
    }
    for (std::size_t reason = 0; reason < far_reasons; ++reason)
        if (others[reason] != 0)
            chosen.others[std::string(far_reason_names[reason])] = others[reason];
    return chosen;
}

} // namespace

std::optional<StepsToRead> steps_to_read(const Trace& trace, Pixel pixel, std::size_t nearest,
                                         std::size_t jobs) {
    const TraceIndex* const index = trace.index();
    if (index != nullptr && !index->knows_units())
        return std::nullopt;
    const TraceContents contents = index == nullptr ? contents_of(trace, jobs) : TraceContents();
    if (index == nullptr && !contents.known.are_known)
        return std::nullopt;
    std::set<std::string> vertices;
    auto chosen =
        chosen_steps(trace,
                     index != nullptr ? Choice{index->units(), index->other_units(),
                                               index->primitives(), index->loose_steps()}
                                      : Choice{contents.known.units, contents.known.others,
                                               contents.primitives, contents.loose},
                     pixel, nearest, vertices);
    if (!chosen)
        return std::nullopt;
    auto& steps = chosen->steps;
    if (index != nullptr)
        for (const std::string& name : vertices) {
            const auto of_vertex = index->vertex_steps(name);
            steps.insert(steps.end(), of_vertex.begin(), of_vertex.end());
        }
    for (const std::uint32_t n : contents.vertices)
        if (vertices.contains(name_in(trace.step(n)).text()))
            steps.push_back(n);
    std::sort(steps.begin(), steps.end());
    steps.erase(std::unique(steps.begin(), steps.end()), steps.end());
    return chosen;
}

} // namespace rastertrace
