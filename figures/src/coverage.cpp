// SPDX-License-Identifier: MIT
#include "coverage.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <utility>

namespace rastertrace {

namespace {

/// Each row of pixels has so many lines of samples; along a line, coverage is exact to a 256th of a pixel.
constexpr int lines_per_pixel = 16;
constexpr int parts_per_pixel = 256;
constexpr int whole_pixel = lines_per_pixel * parts_per_pixel;

/// The first line of samples at or below y. Samples are in the middle of their lines.
std::int64_t line_at(double y, int height) {
    const double line = std::ceil(y * lines_per_pixel - 0.5);
    return static_cast<std::int64_t>(
        std::clamp(line, 0.0, static_cast<double>(height) * lines_per_pixel));
}

double twice_area(std::span<const Place> polygon) {
    double sum = 0;
    for (std::size_t i = 0; i < polygon.size(); ++i) {
        const Place& a = polygon[i];
        const Place& b = polygon[(i + 1) % polygon.size()];
        sum += a.x * b.y - b.x * a.y;
    }
    return sum;
}

} // namespace

void PixelCoverage::add_edge(Place from, Place to) {
    const int winding = from.y < to.y ? 1 : -1;
    if (winding < 0)
        std::swap(from, to);
    const std::int64_t first = line_at(from.y, height_);
    const std::int64_t end = line_at(to.y, height_);
    if (first < end)
        edges_.push_back({from.x, from.y, (to.x - from.x) / (to.y - from.y), first, end, winding});
}

void PixelCoverage::add(std::span<const Place> polygon) {
    // What lies to the right of the bitmap, above or below covers nothing of it; nor does what lies to the left.
    const auto is_all = [polygon](auto is_outside) {
        return std::all_of(polygon.begin(), polygon.end(), is_outside);
    };
    if (is_all([](Place place) { return place.x <= 0; }) ||
        is_all([](Place place) { return place.y <= 0; }) ||
        is_all([this](Place place) { return place.x >= width_; }) ||
        is_all([this](Place place) { return place.y >= height_; }))
        return;
    for (std::size_t i = 0; i < polygon.size(); ++i)
        add_edge(polygon[i], polygon[(i + 1) % polygon.size()]);
}

void PixelCoverage::add_positive(std::span<const Place> polygon) {
    if (twice_area(polygon) >= 0)
        return add(polygon);
    std::vector<Place> turned(polygon.rbegin(), polygon.rend());
    add(turned);
}

void PixelCoverage::add(const CoveredBox& box) {
    if (box.left >= box.right || box.right <= 0 || box.left >= width_)
        return;
    add_edge({box.right, box.top}, {box.right, box.bottom});
    add_edge({box.left, box.bottom}, {box.left, box.top});
}

void PixelCoverage::add_line(std::int64_t line, int weight) {
    crossings_.clear();
    const double y = (static_cast<double>(line) + 0.5) / lines_per_pixel;
    for (const Edge& edge : active_)
        if (edge.first <= line && line < edge.end) {
            const double x =
                std::clamp(edge.x + (y - edge.y) * edge.slope, 0.0, static_cast<double>(width_));
            crossings_.push_back(
                {static_cast<std::int64_t>(x * parts_per_pixel + 0.5), edge.winding});
        }
    const auto is_left = [](const Crossing& a, const Crossing& b) { return a.x < b.x; };
    if (!std::is_sorted(crossings_.begin(), crossings_.end(), is_left))
        std::sort(crossings_.begin(), crossings_.end(), is_left);

    // From a crossing on, all of what is to the right is covered: of its own pixel a part, of the others all.
    const auto step = [this, weight](std::int64_t x, int sign) {
        const auto pixel = static_cast<std::size_t>(x / parts_per_pixel);
        const auto left_out = static_cast<int>(x % parts_per_pixel);
        steps_[pixel] += sign * weight * (parts_per_pixel - left_out);
        steps_[pixel + 1] += sign * weight * left_out;
    };
    int winding = 0;
    for (const Crossing& crossing : crossings_) {
        const int before = winding;
        winding += crossing.winding;
        if (before == 0 && winding != 0)
            step(crossing.x, 1);
        else if (before != 0 && winding == 0)
            step(crossing.x, -1);
    }
}

void PixelCoverage::tell_row(int y, const std::function<void(const CoverageRun&)>& tell) {
    int covered = 0;
    CoverageRun run{y, 0, 0, 0};
    for (int x = 0; x < width_; ++x) {
        int& step = steps_[static_cast<std::size_t>(x)];
        if (step == 0)
            continue;
        covered += std::exchange(step, 0);
        const int level = (covered * full_coverage + whole_pixel / 2) / whole_pixel;
        if (level == run.level)
            continue;
        run.end = x;
        if (run.level != 0)
            tell(run);
        run.begin = x;
        run.level = level;
    }
    run.end = width_;
    if (run.level != 0)
        tell(run);
    std::fill(steps_.begin() + width_, steps_.end(), 0);
}

void PixelCoverage::for_each_run(const std::function<void(const CoverageRun&)>& tell) {
    // Two more: a step at the right border has its parts behind it.
    steps_.resize(static_cast<std::size_t>(width_) + 2);
    std::stable_sort(edges_.begin(), edges_.end(),
                     [](const Edge& a, const Edge& b) { return a.first < b.first; });
    std::size_t next = 0;
    for (std::int64_t row = 0; next < edges_.size() || !active_.empty(); ++row) {
        if (active_.empty())
            row = edges_[next].first / lines_per_pixel;
        const std::int64_t first = row * lines_per_pixel;
        const std::int64_t end = first + lines_per_pixel;
        for (; next < edges_.size() && edges_[next].first < end; ++next)
            active_.push_back(edges_[next]);

        // Most lines of the row meet the edges in the order in which its middle does.
        const double middle = static_cast<double>(row) + 0.5;
        std::sort(active_.begin(), active_.end(), [middle](const Edge& a, const Edge& b) {
            return a.x + (middle - a.y) * a.slope < b.x + (middle - b.y) * b.slope;
        });

        // Where all edges run straight down through the row, one line tells what the others would.
        if (std::all_of(active_.begin(), active_.end(), [&](const Edge& edge) {
                return edge.slope == 0 && edge.first <= first && end <= edge.end;
            }))
            add_line(first, lines_per_pixel);
        else
            for (std::int64_t line = first; line < end; ++line)
                add_line(line, 1);
        tell_row(static_cast<int>(row), tell);
        std::erase_if(active_, [end](const Edge& edge) { return edge.end <= end; });
    }
    edges_.clear();
}

} // namespace rastertrace
