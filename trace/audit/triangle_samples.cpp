// SPDX-License-Identifier: MIT
#include "triangle_samples.h"

#include <rastertrace/core/numbers/number.h>
#include <rastertrace/trace/tell/formula.h>
#include <rastertrace/trace/tell/step_text.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <tuple>

namespace rastertrace {

namespace {

/// Half an ulp of 1: what one rounding puts a double off, relative to it.
constexpr double half_ulp = 0x1p-53;

/// Added to every bound on an error: products of doubles may be smaller than the smallest double.
constexpr double least_error = 1e-300;

/// A double and what it may be off.
struct Bounded {
    double value;
    double error;

    /// Its sign, if it is farther from 0 than its error and `margin`; else 0, also of NaN.
    int sign(double margin = 0) const {
        const double doubt = error + margin;
        return value > doubt ? 1 : value < -doubt ? -1 : 0;
    }
};

/// a dx + b dy, of differences of coordinates that were rounded once and lie up to `spread` off. Of the sixteen half
/// ulps, six are needed.
Bounded sum_of_products(double a, double dx, double b, double dy, double spread) {
    const double p = a * dx;
    const double q = b * dy;
    return {p + q, 16 * half_ulp * (std::abs(p) + std::abs(q)) +
                       spread * (std::abs(a) + std::abs(b) + std::abs(dx) + std::abs(dy) + spread) +
                       least_error};
}

/// What the differences between coordinates of some points may be off because these are no doubles.
template <typename... Points> double spread_of(const Points&... points) {
    const bool are_doubles = ((points.x.is_double() && points.y.is_double()) && ...);
    const double farthest =
        std::max({std::max(std::abs(points.x.nearest()), std::abs(points.y.nearest()))...});
    return are_doubles ? 0 : 8 * half_ulp * farthest;
}

/// The pixels whose sample points have a x + b y + c >= 0.
HalfPlane half_plane(const mpq_class& a, const mpq_class& b, const mpq_class& c,
                     const CanvasSamples& grid) {
    // From the sample point to the pixel that it belongs to.
    const mpq_class at_pixel = c + a * grid.offset.x() + b * grid.offset.y();

    // The same over a common denominator, and without it.
    mpz_class denominator = a.get_den();
    for (const mpq_class* value : {&b, &at_pixel})
        mpz_lcm(denominator.get_mpz_t(), denominator.get_mpz_t(), value->get_den_mpz_t());
    const auto whole = [&denominator](const mpq_class& value) {
        return mpz_class(value.get_num() * (denominator / value.get_den()));
    };
    return {whole(a), whole(b), whole(at_pixel)};
}

/// A whole number of any size, held between two that are on the canvas or next to it.
Index clamped(const mpz_class& value, Index low, Index high) {
    if (value < low)
        return low;
    return value > high ? high : value.get_si();
}
Index clamped(double value, Index low, Index high) {
    return static_cast<Index>(
        std::clamp(value, static_cast<double>(low), static_cast<double>(high)));
}

/// The same point in fractions.
Vec2 exact_point(const ScreenPoint& point) {
    return {point.x.exact(), point.y.exact()};
}

/// How far rounding may put an edge function of a triangle off, at a sample in its box, when all is worked out in the
/// numbers of the trace. Weights and edge functions are sums of products of a length in x and one in y, none larger
/// than the box: of up to 32 roundings, each puts them off by half an ulp of such a product. The ends of a row are a
/// coordinate plus a length, with up to four roundings, and count times a side of the box.
template <typename Number>
Number rounding_error(const Number& width, const Number& height, const Number& farthest,
                      const Number& one_rounding) {
    return one_rounding * (32 * width * height + 4 * (width + height) * farthest);
}

} // namespace

Coordinate::Coordinate(const mpq_class& value) : nearest_(nearest_double(value)) {
    if (!std::isfinite(nearest_) || mpq_class(nearest_) != value)
        fraction_ = std::make_shared<const mpq_class>(value);
}

HalfPlane left_of(const ScreenPoint& from, const ScreenPoint& to, const CanvasSamples& grid,
                  const mpq_class& widening) {
    const auto [x, y] = exact_point(from);
    const mpq_class dx = to.x.exact() - x;
    const mpq_class dy = to.y.exact() - y;
    return half_plane(-dy, dx, dy * x - dx * y + widening, grid);
}

HalfPlane opposite(const HalfPlane& plane) {
    return {-plane.a, -plane.b, -plane.c};
}

HalfPlane widened(const HalfPlane& plane, const mpz_class& by) {
    return {plane.a, plane.b, plane.c + by};
}

ConvexRegion interior_of(ConvexRegion region) {
    for (HalfPlane& plane : region)
        plane.c -= 1;
    return region;
}

ConvexRegion between_ends(const ScreenPoint& from, const ScreenPoint& to,
                          const CanvasSamples& grid) {
    const bool runs_along_x =
        abs(to.x.exact() - from.x.exact()) >= abs(to.y.exact() - from.y.exact());
    const auto [low, high] = runs_along_x ? std::minmax(from.x, to.x) : std::minmax(from.y, to.y);
    const mpq_class along_x = runs_along_x ? 1 : 0;
    const mpq_class along_y = 1 - along_x;
    return {half_plane(along_x, along_y, -low.exact(), grid),
            half_plane(-along_x, -along_y, high.exact(), grid)};
}

Span span_on_row(const ConvexRegion& region, int y, const Span& within) {
    Span span = within;
    mpz_class bound;
    for (const HalfPlane& plane : region) {
        // a x >= -rest; the division gives the outermost x.
        const mpz_class rest = plane.b * y + plane.c;
        const int sign = sgn(plane.a);
        if (sign > 0) {
            mpz_fdiv_q(bound.get_mpz_t(), rest.get_mpz_t(), plane.a.get_mpz_t());
            bound = -bound;
            span.first = std::max(span.first, clamped(bound, within.first, within.last + 1));
        } else if (sign < 0) {
            bound = -plane.a;
            mpz_fdiv_q(bound.get_mpz_t(), rest.get_mpz_t(), bound.get_mpz_t());
            span.last = std::min(span.last, clamped(bound, within.first - 1, within.last));
        } else if (sgn(rest) < 0) {
            span.last = within.first - 1;
        }
        if (span.is_empty())
            return {within.last + 1, within.last};
    }
    return span;
}

Span rows_between(const Coordinate& low, const Coordinate& high, const CanvasSamples& grid) {
    const auto [lowest, highest] = std::minmax<Index>({grid.canvas.top(), grid.canvas.bottom()});
    // In doubles up to one off.
    Index from = clamped(std::ceil(low.nearest() - grid.y), lowest, highest + 1);
    while (from > lowest && grid.y_of(from - 1) >= low)
        --from;
    while (from <= highest && grid.y_of(from) < low)
        ++from;
    Index to = clamped(std::floor(high.nearest() - grid.y), lowest - 1, highest);
    while (to < highest && grid.y_of(to + 1) <= high)
        ++to;
    while (to >= lowest && grid.y_of(to) > high)
        --to;
    if (to < from)
        return {};
    const auto [first, last] = std::minmax({grid.canvas.row_of(from), grid.canvas.row_of(to)});
    return {first, last};
}

Span whole_row(const Canvas& canvas) {
    return {canvas.left(), canvas.right()};
}

int orientation(const ScreenPoint& a, const ScreenPoint& b, const ScreenPoint& c) {
    const Bounded near = sum_of_products(
        b.x.nearest() - a.x.nearest(), c.y.nearest() - a.y.nearest(), a.x.nearest() - c.x.nearest(),
        b.y.nearest() - a.y.nearest(), spread_of(a, b, c));
    return near.sign() != 0 ? near.sign()
                            : sgn(doubled_area(exact_point(a), exact_point(b), exact_point(c)));
}

TriangleSamples::TriangleSamples(const std::array<ScreenPoint, 3>& at, const CanvasSamples& grid,
                                 double one_rounding)
    : at_(&at), grid_(&grid), one_rounding_(one_rounding),
      orientation_(orientation(at[0], at[1], at[2])),
      spread_(spread_of(at[0], at[1], at[2]) + 4 * grid.error) {
    for (std::size_t i = 0; i < 3; ++i) {
        const auto& [from, to] =
            orientation_ > 0 ? std::tie(at[i], at[(i + 1) % 3]) : std::tie(at[(i + 1) % 3], at[i]);
        edges_[i] = {from.x.nearest(), from.y.nearest(), from.y.nearest() - to.y.nearest(),
                     to.x.nearest() - from.x.nearest()};
    }
    const auto [left, right] =
        std::minmax({at[0].x.nearest(), at[1].x.nearest(), at[2].x.nearest()});
    const auto [low, high] = std::minmax({at[0].y.nearest(), at[1].y.nearest(), at[2].y.nearest()});
    const double farthest =
        std::max({std::abs(left), std::abs(right), std::abs(low), std::abs(high)});
    constexpr double more = 1.001; // than what is rounded here
    error_ =
        more * rounding_error(right - left + spread_, high - low + spread_, farthest, one_rounding);

    // The region with edge functions from -error is the triangle, scaled from its centroid by 1 + 3 error/area.
    const Bounded area =
        sum_of_products(edges_[0].b, edges_[1].a, -edges_[0].a, edges_[1].b, spread_);
    const double least_area = std::abs(area.value) - area.error;
    extent_ = least_area > 0 ? 3 * error_ / least_area * (high - low)
                             : std::numeric_limits<double>::infinity();
}

/// Of a sample: 1 or -1 if it lies on the triangle's side of an edge or on the other one, whatever rounding does; else 0.
int TriangleSamples::side_of(const NearEdge& edge, double x, double y) const {
    return sum_of_products(edge.a, x - edge.x, edge.b, y - edge.y, spread_).sign(error_);
}

/// The part of a row that lies in the triangle, if that is the same whatever rounding does.
std::optional<Span> TriangleSamples::clear_span(int y) const {
    const Span all = whole_row(grid_->canvas);
    const Span none{all.last + 1, all.last};
    const double sample_y = y + grid_->y;
    Span span = all;
    for (const NearEdge& edge : edges_) {
        // An edge function is linear: of one sign between two samples, if it has that sign at both.
        const auto all_are_on = [&](int side, Index first, Index last) {
            return first > last ||
                   (side_of(edge, static_cast<double>(first) + grid_->x, sample_y) == side &&
                    side_of(edge, static_cast<double>(last) + grid_->x, sample_y) == side);
        };
        const double crossing = edge.x - edge.b * (sample_y - edge.y) / edge.a - grid_->x;
        if (std::isnan(crossing))
            return std::nullopt;
        const Index behind = clamped(std::ceil(crossing), all.first, all.last + 1);
        const bool is_inside_behind = edge.a > 0;
        if (!std::isfinite(crossing)) {
            // The row runs along the edge.
            if (all_are_on(-1, all.first, all.last))
                return none;
            if (!all_are_on(1, all.first, all.last))
                return std::nullopt;
            continue;
        }
        const int side_behind = is_inside_behind ? 1 : -1;
        if (!all_are_on(-side_behind, all.first, behind - 1) ||
            !all_are_on(side_behind, behind, all.last))
            return std::nullopt;
        if (is_inside_behind)
            span.first = std::max(span.first, behind);
        else
            span.last = std::min(span.last, behind - 1);
        if (span.is_empty())
            return none;
    }
    return span;
}

TriangleSamples::Row TriangleSamples::row(int y) const {
    if (const auto span = clear_span(y))
        return {*span, *span, *span};
    const Span all = whole_row(grid_->canvas);
    const Span closed = span_on_row(regions().closed, y, all);
    return {closed, span_on_row(regions().interior, y, closed),
            span_on_row(regions().within_error, y, all)};
}

bool TriangleSamples::is_clear() const {
    if (!(extent_ < 1))
        return false;
    // Also next to it.
    const auto [low, high] =
        std::minmax({(*at_)[0].y.nearest(), (*at_)[1].y.nearest(), (*at_)[2].y.nearest()});
    const Span rows = rows_between(Coordinate(low - 2), Coordinate(high + 2), *grid_);
    for (Index row = rows.first; row <= rows.last; ++row)
        if (!clear_span(grid_->canvas.y_of(static_cast<int>(row))))
            return false;
    return true;
}

const TriangleSamples::Regions& TriangleSamples::regions() const {
    if (regions_)
        return *regions_;
    std::array<mpq_class, 3> x, y;
    for (std::size_t i = 0; i < 3; ++i) {
        x[i] = (*at_)[i].x.exact();
        y[i] = (*at_)[i].y.exact();
    }
    const auto [left, right] = std::minmax({x[0], x[1], x[2]});
    const auto [low, high] = std::minmax({y[0], y[1], y[2]});
    const mpq_class farthest = std::max<mpq_class>({abs(left), abs(right), abs(low), abs(high)});
    const mpq_class error =
        rounding_error<mpq_class>(right - left, high - low, farthest, one_rounding_);
    const auto region = [this](const mpq_class& widening) {
        ConvexRegion planes;
        for (std::size_t i = 0; i < 3; ++i) {
            const ScreenPoint& from = (*at_)[i];
            const ScreenPoint& to = (*at_)[(i + 1) % 3];
            planes.push_back(orientation_ > 0 ? left_of(from, to, *grid_, widening)
                                              : left_of(to, from, *grid_, widening));
        }
        return planes;
    };
    regions_ = std::make_shared<const Regions>(
        Regions{region(0), interior_of(region(-error)), region(error)});
    return *regions_;
}

} // namespace rastertrace
