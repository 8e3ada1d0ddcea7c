// SPDX-License-Identifier: MIT
#include "stroke.h"

#include "clip.h"

#include <agg2/agg_conv_dash.h>
#include <agg2/agg_conv_stroke.h>
#include <agg2/agg_ellipse.h>
#include <agg2/agg_path_storage.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

namespace rastertrace {

namespace {

double distance(Place a, Place b) {
    return std::sqrt((b.x - a.x) * (b.x - a.x) + (b.y - a.y) * (b.y - a.y));
}

/// `Line` is a path, or dashes along one.
template <typename Line> void add_solid(Line& line, double width, PixelCoverage& coverage) {
    agg::conv_stroke<Line> stroke(line);
    stroke.width(width);
    stroke.line_join(agg::round_join);
    stroke.inner_join(agg::inner_round);
    stroke.line_cap(agg::butt_cap);
    constexpr double finer = 4; // than an eighth of a pixel from the true circle
    stroke.approximation_scale(finer);
    coverage.add_outline(stroke);
}

/// Adds the dashes that can be seen: a line may come from so far away that all of them are more than memory holds.
void add_dashed(const std::vector<Place>& path, const Pen& pen, double period,
                PixelCoverage& coverage) {
    const Rectangle visible{{-pen.width, -pen.width},
                            coverage.width() + 2 * pen.width,
                            coverage.height() + 2 * pen.width};
    agg::path_storage part; // that can be seen
    agg::conv_dash<agg::path_storage> dashes(part);
    for (std::size_t i = 0; i + 1 < pen.dashes.size(); i += 2)
        dashes.add_dash(pen.dashes[i], pen.dashes[i + 1]);
    const auto finish = [&] {
        if (part.total_vertices() > 0)
            add_solid(dashes, pen.width, coverage);
        part.remove_all();
    };
    double length = 0; // of the path up to the piece
    for (std::size_t i = 1; i < path.size(); ++i) {
        const Place a = path[i - 1];
        const Place b = path[i];
        const auto piece = clipped(a, b, visible);
        if (piece && (part.total_vertices() == 0 || !(piece->first == a))) {
            finish();
            dashes.dash_start(std::fmod(length + distance(a, piece->first), period));
            part.move_to(piece->first.x, piece->first.y);
        }
        if (piece)
            part.line_to(piece->second.x, piece->second.y);
        if (!piece || !(piece->second == b))
            finish();
        length += distance(a, b);
    }
    finish();
}

} // namespace

void add_stroke(std::span<const Place> path, const Pen& pen, PixelCoverage& coverage) {
    if (path.size() < 2 || pen.width <= 0)
        return;
    double period = 0;
    for (const double dash : pen.dashes)
        period += dash;
    // Dashes of less than half a pixel all together cannot be told from a line.
    constexpr double shortest_period = 0.5;
    if (period >= shortest_period) {
        std::vector<Place> places(path.begin(), path.end());
        if (pen.joins_ends)
            places.push_back(path.front());
        return add_dashed(places, pen, period, coverage);
    }
    agg::path_storage line;
    line.move_to(path[0].x, path[0].y);
    for (const Place& place : path.subspan(1))
        line.line_to(place.x, place.y);
    if (pen.joins_ends)
        line.close_polygon();
    add_solid(line, pen.width, coverage);
}

void add_disc(Place center, double radius, PixelCoverage& coverage) {
    if (radius <= 0)
        return;
    // At most a 25th of a pixel inside the true circle, for radii up to 500 pixels.
    constexpr double corners = 11.2; // with a radius of 1; they grow as its root
    const double count = std::clamp(std::ceil(corners * std::sqrt(radius)), 16.0, 256.0);
    agg::ellipse disc(center.x, center.y, radius, radius, static_cast<unsigned>(count));
    coverage.add_outline(disc);
}

} // namespace rastertrace
