// SPDX-License-Identifier: MIT
#include "triangle_samples.h"

#include <rastertrace/core/numbers/rational.h>

#include <cmath>
#include <limits>

namespace rastertrace {

namespace {

/// A whole number held between two that are on the canvas or next to it.
Index clamped(double value, Index low, Index high) {
    if (!(value >= static_cast<double>(low)))
        return low;
    return value > static_cast<double>(high) ? high : static_cast<Index>(value);
}

EdgeFunction<Rational> exact_function(const ScreenPoint& from, const ScreenPoint& to) {
    return edge_function<Rational>({{from.x.exact(), from.y.exact()}, 0},
                                   {{to.x.exact(), to.y.exact()}, 1});
}

/// How far rounding may put an edge function of a triangle off, at a sample in its box, when all is worked out in the
/// numbers of the trace. Weights and edge functions are sums of products of a length in x and one in y, none larger
/// than the box: of up to 32 roundings, each puts them off by half an ulp of such a product. The ends of a row are a
/// coordinate plus a length, with up to four roundings, and count times a side of the box.
double rounding_error(const std::array<ScreenPoint, 3>& at, double one_rounding) {
    if (one_rounding == 0)
        return 0;
    const auto [left, right] =
        std::minmax({at[0].x.nearest(), at[1].x.nearest(), at[2].x.nearest()});
    const auto [low, high] = std::minmax({at[0].y.nearest(), at[1].y.nearest(), at[2].y.nearest()});
    const double width = right - left;
    const double height = high - low;
    const double farthest =
        std::max({std::abs(left), std::abs(right), std::abs(low), std::abs(high)});
    constexpr double more = 1.001; // than what is rounded here
    const double error =
        more * one_rounding * (32 * width * height + 4 * (width + height) * farthest);
    return std::isnan(error) ? std::numeric_limits<double>::infinity() : error;
}

} // namespace

Coordinate::Coordinate(const mpq_class& value) : nearest_(nearest_double(value)) {
    if (!std::isfinite(nearest_) || mpq_class(nearest_) != value)
        fraction_ = std::make_shared<const mpq_class>(value);
}

Span CanvasSamples::all_columns() const {
    return {canvas.left(), canvas.right()};
}

Span CanvasSamples::rows_about(const Coordinate& low, const Coordinate& high) const {
    const auto [lowest, highest] = std::minmax<Index>({canvas.top(), canvas.bottom()});
    const Index from = clamped(std::floor(low.nearest()) - 2, lowest, highest + 1);
    const Index to = clamped(std::ceil(high.nearest()) + 2, lowest - 1, highest);
    if (to < from)
        return {};
    const auto [first, last] = std::minmax({canvas.row_of(from), canvas.row_of(to)});
    return {first, last};
}

ExactEdge::ExactEdge(const ScreenPoint& from, const ScreenPoint& to)
    : from_(&from), to_(&to), near_(edge_function<double>({{from.x.nearest(), from.y.nearest()}, 0},
                                                          {{to.x.nearest(), to.y.nearest()}, 1})),
      farthest_(std::max({std::abs(from.x.nearest()), std::abs(from.y.nearest()),
                          std::abs(to.x.nearest()), std::abs(to.y.nearest())})) {}

int ExactEdge::sign(const ScreenPoint& at, double margin) const {
    if (std::isinf(margin))
        return margin > 0 ? 1 : -1;
    // With u = 2^-53 and coordinates up to M, each difference of two is off by 4 u M at most, and the function by
    // 9 u M times the sum of all four.
    const Vec<double, 2> near{at.x.nearest(), at.y.nearest()};
    const double value = near_.at(near) + margin;
    const double farthest = std::max({farthest_, std::abs(near.x), std::abs(near.y)});
    const double lengths = std::abs(near_.a) + std::abs(near_.b) +
                           std::abs(near.x - near_.start.x) + std::abs(near.y - near_.start.y);
    constexpr double least = 1e-300; // a product may be smaller than the smallest double
    const double doubt =
        0x1p-49 * farthest * (lengths + 0x1p-49 * farthest) + 0x1p-52 * std::abs(margin) + least;
    if (value > doubt)
        return 1;
    if (value < -doubt)
        return -1;
    return sgn(exact_function(*from_, *to_).at({at.x.exact(), at.y.exact()}) + Rational(margin));
}

double ExactEdge::near_x_at(double y) const {
    return near_.start.x - near_.b * (y - near_.start.y) / near_.a;
}

Span ExactEdge::columns_near(double y, const Span& columns) const {
    const auto [low, high] = std::minmax({near_x_at(y - 2), near_x_at(y + 2)});
    if (!std::isfinite(low) || !std::isfinite(high))
        return columns;
    const double around = 2 + 0x1p-40 * farthest_; // of far points, what is rounded counts
    return {clamped(std::floor(low - around), columns.first, columns.last + 1),
            clamped(std::ceil(high + around), columns.first - 1, columns.last)};
}

int orientation(const ScreenPoint& a, const ScreenPoint& b, const ScreenPoint& c) {
    return ExactEdge(a, b).sign(c);
}

std::vector<Pixel> pixels_near(const ScreenPoint& from, const ScreenPoint& to,
                               const CanvasSamples& grid) {
    if (from == to)
        return {};
    const ExactEdge edge(from, to);
    const bool runs_along_x =
        abs(to.x.exact() - from.x.exact()) >= abs(to.y.exact() - from.y.exact());
    const Coordinate& first = runs_along_x ? std::min(from.x, to.x) : std::min(from.y, to.y);
    const Coordinate& last = runs_along_x ? std::max(from.x, to.x) : std::max(from.y, to.y);
    const auto is_near = [&](Index x, int y) {
        const ScreenPoint sample = grid.sample_of(x, y);
        const Coordinate& along = runs_along_x ? sample.x : sample.y;
        if (along < first || last < along)
            return false;
        // The edge passes between the samples on both sides, or through one of them.
        const ScreenPoint before =
            runs_along_x ? grid.sample_of(x, y - 1) : grid.sample_of(x - 1, y);
        const ScreenPoint behind =
            runs_along_x ? grid.sample_of(x, y + 1) : grid.sample_of(x + 1, y);
        return edge.sign(before) * edge.sign(behind) <= 0;
    };

    std::vector<Pixel> pixels;
    const auto [low, high] = std::minmax(from.y, to.y);
    const Span rows = grid.rows_about(low, high);
    for (Index row = rows.first; row <= rows.last; ++row) {
        const int y = grid.canvas.y_of(static_cast<int>(row));
        const Span columns = edge.columns_near(y + grid.offset, grid.all_columns());
        for (Index x = columns.first; x <= columns.last; ++x)
            if (is_near(x, y))
                pixels.push_back({static_cast<int>(x), y});
    }
    return pixels;
}

TriangleSamples::TriangleSamples(const std::array<ScreenPoint, 3>& at, const CanvasSamples& grid)
    : grid_(&grid), edges_{ExactEdge(at[0], at[1]), ExactEdge(at[1], at[2]),
                           ExactEdge(at[2], at[0])},
      error_(rounding_error(at, grid.one_rounding)) {
    if (orientation(at[0], at[1], at[2]) < 0)
        edges_ = {ExactEdge(at[1], at[0]), ExactEdge(at[2], at[1]), ExactEdge(at[0], at[2])};
}

bool TriangleSamples::admits(std::size_t edge, Index x, int y, Place place) const {
    const ScreenPoint sample = grid_->sample_of(x, y);
    return place == Place::inside ? edges_[edge].sign(sample, -error_) > 0
                                  : edges_[edge].sign(sample, error_) >= 0;
}

/// The part of a row that an edge admits.
Span TriangleSamples::span_of_edge(std::size_t edge, int y, Place place) const {
    const Span all = grid_->all_columns();
    const Coordinate& from = edges_[edge].from().y;
    const Coordinate& to = edges_[edge].to().y;
    if (from == to)
        return admits(edge, all.first, y, place) ? all : Span{};
    // The function grows with x, or falls: of one side up to a column, of the other one from there.
    const bool grows = to < from;
    const auto is_in_front = [&](Index x) { return admits(edge, x, y, place) != grows; };
    const Index end = all.last + 1;
    const double crossing = edges_[edge].near_x_at(y + grid_->offset) - grid_->offset;
    Index behind = clamped(std::ceil(crossing), all.first, end);
    if ((behind < end && is_in_front(behind)) || (behind > all.first && !is_in_front(behind - 1))) {
        behind = all.first;
        for (Index after = end; behind < after;) {
            const Index between = behind + (after - behind) / 2;
            is_in_front(between) ? behind = between + 1 : after = between;
        }
    }
    return grows ? Span{behind, all.last} : Span{all.first, behind - 1};
}

Span TriangleSamples::span_of(int y, Place place) const {
    return common_part(common_part(span_of_edge(0, y, place), span_of_edge(1, y, place)),
                       span_of_edge(2, y, place));
}

TriangleSamples::Row TriangleSamples::row(int y) const {
    return {span_of(y, Place::inside), span_of(y, Place::within_error)};
}

} // namespace rastertrace
