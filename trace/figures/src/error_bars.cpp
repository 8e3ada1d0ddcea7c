// SPDX-License-Identifier: MIT
#include "error_bars.h"

#include <rastertrace/trace/record/traced_steps.h>

#include <algorithm>
#include <cmath>

namespace rastertrace {

std::optional<Decisions> decisions_of(const Replay& replay) {
    const Trace& trace = replay.trace();
    if (replay.primitive() == 0 || !trace.method.draws_lines_by(LineMethod::bresenham))
        return std::nullopt;
    // An outline has three lines: each begins with its edge.
    std::size_t first = replay.primitive();
    auto octant = trace.step(first).as<PrimitiveStep>().octant;
    for (const std::size_t n : trace.steps_of({StepKind::edge}, first + 1, replay.step())) {
        first = n;
        octant = trace.step(n).as<EdgeStep>().octant;
    }
    Decisions decisions;
    bool goes_straight_up = false;
    for (const std::size_t n : trace.steps_of({StepKind::decide}, first + 1, replay.step())) {
        const auto step = trace.step(n).as<DecideStep>();
        const auto pixel = pixel_of(trace, n);
        const auto d = step.d.nearest_double();
        if (!pixel || !d)
            continue;
        goes_straight_up = goes_straight_up || step.move == Move::n || step.move == Move::s;
        decisions.all.push_back({*pixel, *d, step.d.text()});
    }
    if (decisions.all.empty())
        return std::nullopt;
    // A line that goes straight only up or down, or is told to by its octant, has a decision for each row.
    const auto is_steep_octant = [](Index number) {
        return number == 2 || number == 3 || number == 6 || number == 7;
    };
    decisions.is_steep = octant ? is_steep_octant(*octant) : goes_straight_up;
    return decisions;
}

void add_error_bars(const Decisions& decisions, const Lattice& lattice, double from,
                    std::vector<Shape>& shapes) {
    double largest = 1;
    for (const Decision& decision : decisions.all)
        largest = std::max(largest, std::abs(decision.d));

    // Along the strip are columns or rows, across it is d.
    constexpr double text_size = 9;
    constexpr double room_for_text = 13;
    constexpr double half = error_bars_size / 2 - room_for_text;
    constexpr double slimness = 0.55; // of a bar to its pixel
    const double zero = from + error_bars_size / 2;
    const bool is_steep = decisions.is_steep;
    const auto place = [is_steep](double along, double across) {
        return is_steep ? Place{across, along} : Place{along, across};
    };
    const Rectangle frame = lattice.frame();
    shapes.push_back(Lines{.role = Role::axis,
                           .paths = {{place(is_steep ? frame.corner.y : frame.corner.x, zero),
                                      place(is_steep ? frame.bottom() : frame.right(), zero)}}});
    Areas above{.role = Role::bar};
    Areas below{.role = Role::bar_below};
    std::vector<Shape> labels;
    for (const Decision& decision : decisions.all) {
        if (!lattice.has(decision.pixel))
            continue;
        const Place middle = lattice.middle_of(decision.pixel);
        const double along = is_steep ? middle.y : middle.x;
        const double thick = slimness * lattice.cell;
        const double length = half * std::abs(decision.d) / largest;
        // More is up, or to the right.
        const double sign = decision.d < 0 ? -1 : 1;
        const double end = zero + (is_steep ? sign : -sign) * length;
        const Place corner = place(along - thick / 2, std::min(zero, end));
        (decision.d < 0 ? below : above)
            .rectangles.push_back({corner, is_steep ? length : thick, is_steep ? thick : length});
        const double text_across = is_steep         ? end + sign * 3
                                   : decision.d < 0 ? end + text_size
                                                    : end - 3;
        labels.push_back(Label{.role = Role::text,
                               .at = place(along + (is_steep ? 0.35 * text_size : 0), text_across),
                               .text = decision.text,
                               .size = text_size,
                               .anchor = !is_steep        ? Anchor::middle
                                         : decision.d < 0 ? Anchor::end
                                                          : Anchor::start});
    }
    shapes.push_back(std::move(above));
    shapes.push_back(std::move(below));
    shapes.insert(shapes.end(), labels.begin(), labels.end());
    shapes.push_back(Label{.role = Role::quiet_text,
                           .at = is_steep ? Place{zero, frame.bottom() + text_size + 2}
                                          : Place{frame.corner.x - 4, zero + 3},
                           .text = "d",
                           .size = text_size,
                           .anchor = is_steep ? Anchor::middle : Anchor::end});
}

} // namespace rastertrace
