// SPDX-License-Identifier: MIT
#include "visibility.h"

#include <rastertrace/trace/record/traced_steps.h>
#include <rastertrace/trace/tell/corners.h>
#include <rastertrace/trace/tell/formula.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <string>

namespace rastertrace {

namespace {

/// Depths from one corner to the next; of a line, the same beside it.
std::optional<std::array<double, 3>> depths_over(const Path& corners,
                                                 const std::vector<double>& depths) {
    Path at = corners;
    if (at.size() == 2) // a third corner straight beside the first one
        at.push_back({at[0].x - (at[1].y - at[0].y), at[0].y + (at[1].x - at[0].x)});
    return plane_through(at, {depths[0], depths[1], depths.size() == 2 ? depths[0] : depths[2]});
}

} // namespace

Visibility::Visibility(const Panel& panel)
    : frame_(panel.lattice.frame()), cell_(panel.lattice.cell) {
    const Trace& trace = panel.trace();
    is_painted_ = trace.method.triangles.depth == Depth::painter;
    if (!is_painted_ && !has_depth_buffer(trace))
        return;
    larger_is_nearer_ = larger_is_nearer(trace);
    for (const std::size_t step : panel.replay.primitives()) {
        const auto primitive = trace.step(step).as<PrimitiveStep>();
        Surface surface{step, places_of(panel, step), {}};
        std::vector<double> depths;
        for (const TracedNumber& one : primitive.depths.values())
            if (const auto value = one.nearest_double())
                depths.push_back(*value);
        if (surface.corners.size() < 2 || (!is_painted_ && depths.size() != surface.corners.size()))
            continue;
        if (!is_painted_) {
            const auto over = depths_over(surface.corners, depths);
            if (!over)
                continue;
            surface.depth = *over;
        }
        surfaces_.push_back(std::move(surface));
        if (is_filled(primitive.kind))
            add_to_fields(surfaces_.size() - 1);
    }
}

int Visibility::column_of(double x) const {
    return static_cast<int>(
        std::clamp((x - frame_.corner.x) / frame_.width * most_fields, 0.0, most_fields - 1.0));
}

int Visibility::row_of(double y) const {
    return static_cast<int>(
        std::clamp((y - frame_.corner.y) / frame_.height * most_fields, 0.0, most_fields - 1.0));
}

void Visibility::add_to_fields(std::size_t surface) {
    const Path& corners = surfaces_[surface].corners;
    const auto [left, right] = std::minmax_element(
        corners.begin(), corners.end(), [](const Place& a, const Place& b) { return a.x < b.x; });
    const auto [top, bottom] = std::minmax_element(
        corners.begin(), corners.end(), [](const Place& a, const Place& b) { return a.y < b.y; });
    for (int row = row_of(top->y); row <= row_of(bottom->y); ++row)
        for (int column = column_of(left->x); column <= column_of(right->x); ++column)
            fields_[static_cast<std::size_t>(row * most_fields + column)].push_back(surface);
}

bool Visibility::Surface::has(Place at) const {
    bool is_inside = false; // even-odd
    for (std::size_t i = 0; i < corners.size(); ++i) {
        const Place a = corners[i];
        const Place b = corners[(i + 1) % corners.size()];
        const double length = std::hypot(b.x - a.x, b.y - a.y);
        const double side = doubled_area(a, b, at);
        const double along = (b.x - a.x) * (at.x - a.x) + (b.y - a.y) * (at.y - a.y);
        constexpr double on_edge = 1e-6; // units of the sheet
        if (std::abs(side) <= on_edge * length && 0 <= along && along <= length * length)
            return false;
        if ((a.y <= at.y) != (b.y <= at.y) && (side > 0) == (b.y > a.y))
            is_inside = !is_inside;
    }
    return is_inside;
}

bool Visibility::is_before(const Surface& other, const Surface& own, Place at) const {
    if (is_painted_)
        return other.step > own.step;
    constexpr double same = 1e-9; // as a part of both
    const double depth = own.depth_at(at);
    const double others = other.depth_at(at);
    const double difference = larger_is_nearer_ ? others - depth : depth - others;
    return difference > same * (std::abs(depth) + std::abs(others));
}

bool Visibility::is_seen(std::size_t primitive, Place at) const {
    const auto own = std::lower_bound(
        surfaces_.begin(), surfaces_.end(), primitive,
        [](const Surface& surface, std::size_t step) { return surface.step < step; });
    if (own == surfaces_.end() || own->step != primitive)
        return true;
    const auto& near =
        fields_[static_cast<std::size_t>(row_of(at.y) * most_fields + column_of(at.x))];
    return std::none_of(near.begin(), near.end(), [&](std::size_t i) {
        const Surface& other = surfaces_[i];
        return other.step != primitive && other.has(at) && is_before(other, *own, at);
    });
}

std::vector<Path> Visibility::parts_of(std::size_t primitive, const Path& side, bool seen) const {
    const Place from = side.front();
    const Place way{side.back().x - from.x, side.back().y - from.y};
    const auto at = [&](double share) {
        return Place{from.x + share * way.x, from.y + share * way.y};
    };
    const auto is_in = [&](double share) { return is_seen(primitive, at(share)) == seen; };
    // Half a pixel at a time; where it changes in between is found by bisection.
    const int count =
        std::max(1, static_cast<int>(std::ceil(std::hypot(way.x, way.y) / (0.5 * cell_))));
    std::vector<Path> parts;
    bool goes_on = false;
    double last = 0;
    for (int i = 0; i < count; ++i) {
        const double share = (i + 0.5) / count;
        const bool is_part = is_in(share);
        if (is_part != goes_on) {
            double before = last;
            double behind = share;
            for (int k = 0; i > 0 && k < 20; ++k) {
                const double middle = (before + behind) / 2;
                (is_in(middle) == is_part ? behind : before) = middle;
            }
            if (is_part)
                parts.push_back({at(i > 0 ? behind : 0), at(1)});
            else
                parts.back().back() = at(behind);
        }
        goes_on = is_part;
        last = share;
    }
    return parts;
}

} // namespace rastertrace
