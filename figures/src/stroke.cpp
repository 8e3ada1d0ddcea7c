// SPDX-License-Identifier: MIT
#include "stroke.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <optional>
#include <utility>
#include <vector>

namespace rastertrace {

namespace {

Place sum(Place a, Place b) {
    return {a.x + b.x, a.y + b.y};
}

Place difference(Place a, Place b) {
    return {a.x - b.x, a.y - b.y};
}

Place times(Place a, double factor) {
    return {a.x * factor, a.y * factor};
}

double dot(Place a, Place b) {
    return a.x * b.x + a.y * b.y;
}

/// True for places that no drawing shows apart, less than a millionth of a pixel from one another.
bool are_one(Place a, Place b) {
    constexpr double nearest = 1e-6;
    return std::abs(a.x - b.x) < nearest && std::abs(a.y - b.y) < nearest;
}

/// The same direction, of length 1. Roots are rounded alike everywhere, sines are not.
Place unit(Place a) {
    return times(a, 1 / std::sqrt(dot(a, a)));
}

/// Places on the circle around (0, 0), 4 * 2^halvings of them.
std::vector<Place> circle(int halvings) {
    std::vector<Place> places{{1, 0}, {0, 1}, {-1, 0}, {0, -1}};
    for (int i = 0; i < halvings; ++i) {
        std::vector<Place> finer;
        for (std::size_t k = 0; k < places.size(); ++k) {
            finer.push_back(places[k]);
            finer.push_back(unit(sum(places[k], places[(k + 1) % places.size()])));
        }
        places = std::move(finer);
    }
    return places;
}

/// Circles of 16, 32, 64 and 256 places: each is at most a 25th of a pixel inside the true one, for radii up to
/// 2, 8, 32 and 500 pixels.
const std::vector<Place>& circle_for(double radius) {
    static const std::array circles{circle(2), circle(3), circle(4), circle(6)};
    constexpr std::array reaches{2.0, 8.0, 32.0};
    const auto found = std::lower_bound(reaches.begin(), reaches.end(), radius);
    return circles[static_cast<std::size_t>(found - reaches.begin())];
}

/// The corner between two pieces of a line, each given by its direction.
void add_corner(Place at, Place before, Place after, double half, PixelCoverage& coverage) {
    constexpr double nearly_straight = 0.98; // the cosine of 11 degrees
    if (dot(before, after) < nearly_straight)
        return add_disc(at, half, coverage);
    for (const double side : {-half, half})
        coverage.add_positive(std::array<Place, 3>{at, sum(at, {-before.y * side, before.x * side}),
                                                   sum(at, {-after.y * side, after.x * side})});
}

/// A line without dashes. No place is one with the next.
void add_solid(const std::vector<Place>& path, double width, bool joins_ends,
               PixelCoverage& coverage) {
    const double half = width / 2;
    const std::size_t pieces = joins_ends ? path.size() : path.size() - 1;
    std::vector<Place> directions;
    for (std::size_t i = 0; i < pieces; ++i) {
        const Place a = path[i];
        const Place b = path[(i + 1) % path.size()];
        directions.push_back(unit(difference(b, a)));
        const Place across{-directions.back().y * half, directions.back().x * half};
        coverage.add_positive(std::array<Place, 4>{difference(a, across), difference(b, across),
                                                   sum(b, across), sum(a, across)});
    }
    for (std::size_t i = 1; i < pieces; ++i)
        add_corner(path[i], directions[i - 1], directions[i], half, coverage);
    if (joins_ends)
        add_corner(path.front(), directions.back(), directions.front(), half, coverage);
}

/// The part of a piece of a line that can be seen: from `begin` to `end`, both lengths from a.
struct Stretch {
    double begin;
    double end;
};

/// The stretch within the bitmap and `margin` pixels around it; nothing if there is none.
std::optional<Stretch> visible_stretch(Place a, Place direction, double length, double margin,
                                       const PixelCoverage& coverage) {
    Stretch stretch{0, length};
    const auto cut = [&stretch](double at, double step, double low, double high) {
        if (step == 0) {
            if (at < low || high < at)
                stretch.end = -1;
            return;
        }
        const double first = (low - at) / step;
        const double last = (high - at) / step;
        stretch.begin = std::max(stretch.begin, std::min(first, last));
        stretch.end = std::min(stretch.end, std::max(first, last));
    };
    cut(a.x, direction.x, -margin, coverage.width() + margin);
    cut(a.y, direction.y, -margin, coverage.height() + margin);
    if (stretch.begin < stretch.end)
        return stretch;
    return std::nullopt;
}

/// Walks along a line, and adds its dashes.
class Dasher {
public:
    Dasher(const Pen& pen, double period, PixelCoverage& coverage)
        : pen_(pen), period_(period), coverage_(coverage) {}

    void walk(Place a, Place b) {
        const Place way = difference(b, a);
        const double length = std::sqrt(dot(way, way));
        const Place direction = times(way, 1 / length);
        const auto stretch = visible_stretch(a, direction, length, pen_.width, coverage_);
        if (!stretch) {
            finish();
            phase_ = std::fmod(phase_ + length, period_);
            return;
        }
        if (stretch->begin > 0)
            finish();
        phase_ = std::fmod(phase_ + stretch->begin, period_);
        for (double at = stretch->begin; at < stretch->end;) {
            // The dash or gap that the phase is in, and how much of it is left.
            std::size_t index = 0;
            double left = phase_;
            while (index + 1 < pen_.dashes.size() && left >= pen_.dashes[index])
                left -= pen_.dashes[index++];
            left = std::max(pen_.dashes[index] - left, least_);
            const double end = std::min(at + left, stretch->end);
            if (index % 2 == 0) {
                go_to(sum(a, times(direction, at)));
                go_to(sum(a, times(direction, end)));
            }
            if (index % 2 != 0 || at + left <= stretch->end)
                finish();
            phase_ = std::fmod(phase_ + (end - at), period_);
            at = end;
        }
        if (stretch->end < length) {
            finish();
            phase_ = std::fmod(phase_ + (length - stretch->end), period_);
        }
    }

    /// Adds the dash that has been begun.
    void finish() {
        if (dash_.size() > 1)
            add_solid(dash_, pen_.width, false, coverage_);
        dash_.clear();
    }

private:
    void go_to(Place place) {
        if (dash_.empty() || !are_one(dash_.back(), place))
            dash_.push_back(place);
    }

    /// Pixels: what rounding leaves of a dash is passed over.
    static constexpr double least_ = 1e-6;

    Pen pen_;
    double period_;
    PixelCoverage& coverage_;
    double phase_ = 0; ///< how far into the dashes and gaps
    std::vector<Place> dash_;
};

} // namespace

void add_stroke(std::span<const Place> path, const Pen& pen, PixelCoverage& coverage) {
    std::vector<Place> places;
    for (const Place& place : path)
        if (places.empty() || !are_one(places.back(), place))
            places.push_back(place);
    if (pen.joins_ends && places.size() > 1 && are_one(places.front(), places.back()))
        places.pop_back();
    const bool joins_ends = pen.joins_ends && places.size() > 2;
    if (places.size() < 2 || pen.width <= 0)
        return;

    // Dashes of less than half a pixel all together cannot be told from a line.
    constexpr double shortest_period = 0.5;
    double period = 0;
    for (const double dash : pen.dashes)
        period += dash;
    if (period < shortest_period)
        return add_solid(places, pen.width, joins_ends, coverage);
    if (joins_ends)
        places.push_back(places.front());
    Dasher dasher(pen, period, coverage);
    for (std::size_t i = 1; i < places.size(); ++i)
        dasher.walk(places[i - 1], places[i]);
    dasher.finish();
}

void add_disc(Place center, double radius, PixelCoverage& coverage) {
    if (radius <= 0)
        return;
    std::vector<Place> places;
    for (const Place& place : circle_for(radius))
        places.push_back(sum(center, times(place, radius)));
    coverage.add(places);
}

} // namespace rastertrace
