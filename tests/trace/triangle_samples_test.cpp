// SPDX-License-Identifier: MIT
#include <rastertrace/trace/audit/triangle_samples.h>

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace rastertrace {
namespace {

const Canvas small_canvas{12, 9, Origin::bottom_left};

/// A coordinate about the canvas, of those that doubles decide at once and of those that they do not.
rc::Gen<Coordinate> coordinate() {
    const auto whole = rc::gen::inRange(-4, 16);
    const auto eighths =
        rc::gen::map(rc::gen::inRange(-32, 128), [](int n) { return Coordinate(n / 8.0); });
    const auto any = rc::gen::map(rc::gen::inRange(-4'000'000, 16'000'000),
                                  [](int n) { return Coordinate(n / 1.0e6); });
    const auto next_to_half = rc::gen::map(rc::gen::inRange(-8, 32), [](int n) {
        return Coordinate(std::nextafter(n / 2.0, n % 3 == 0 ? 100.0 : -100.0));
    });
    const auto third =
        rc::gen::map(rc::gen::inRange(-12, 48), [](int n) { return Coordinate(mpq_class(n, 3)); });
    const auto hair = rc::gen::map(
        whole, [](int n) { return Coordinate(mpq_class(n) + mpq_class(1, mpz_class(1) << 200)); });
    const auto far =
        rc::gen::map(rc::gen::inRange(-40, 40), [](int n) { return Coordinate(n * 1.0e15 / 3); });
    return rc::gen::weightedOneOf<Coordinate>(
        {{4, eighths}, {3, any}, {2, next_to_half}, {2, third}, {3, hair}, {1, far}});
}

/// Two points on a line through a sample, but for what rounding them to doubles moves them, if they are.
std::array<ScreenPoint, 2> points_about(const mpq_class& x, const mpq_class& y) {
    const auto whole = rc::gen::inRange(1, 1'000'000);
    const mpq_class dx(*rc::gen::inRange(-3'000'000, 3'000'000), *whole);
    const mpq_class dy(*rc::gen::inRange(-3'000'000, 3'000'000), *whole);
    const bool is_rounded = *rc::gen::arbitrary<bool>();
    const auto coordinate_at = [is_rounded](const mpq_class& exact) {
        return is_rounded ? Coordinate(exact.get_d()) : Coordinate(exact);
    };
    const auto point_at = [&](const mpq_class& along) {
        return ScreenPoint{coordinate_at(x + along * dx), coordinate_at(y + along * dy)};
    };
    return {point_at(mpq_class(*whole, 300'000)), point_at(-mpq_class(*whole, 300'000))};
}

struct Expected {
    bool inside = true;
    bool within_error = true;
};

/// The same of one sample by the edge functions themselves, in fractions.
Expected expected_at(const std::array<ScreenPoint, 3>& at, int turn, const mpq_class& error,
                     const mpq_class& x, const mpq_class& y) {
    Expected expected;
    for (std::size_t i = 0; i < 3; ++i) {
        const mpq_class from_x = at[i].x.exact();
        const mpq_class from_y = at[i].y.exact();
        const mpq_class dx = at[(i + 1) % 3].x.exact() - from_x;
        const mpq_class dy = at[(i + 1) % 3].y.exact() - from_y;
        const mpq_class value = turn * (dx * (y - from_y) - dy * (x - from_x));
        expected.inside = expected.inside && value > error;
        expected.within_error = expected.within_error && value >= -error;
    }
    return expected;
}

RC_GTEST_PROP(TriangleSamples, AreThoseOfExactEdgeFunctions, ()) {
    const double moved = *rc::gen::element(0.0, 0.5);
    const SampleOffset<mpq_class> offset(moved, moved);
    std::array<ScreenPoint, 3> at;
    for (ScreenPoint& point : at)
        point = {*coordinate(), *coordinate()};
    if (*rc::gen::arbitrary<bool>()) {
        const auto [one, other] =
            points_about(offset.x_of(*rc::gen::inRange(0, small_canvas.width)),
                         offset.y_of(*rc::gen::inRange(0, small_canvas.height)));
        at[0] = one;
        at[1] = other;
    }
    const mpq_class area =
        (at[1].x.exact() - at[0].x.exact()) * (at[2].y.exact() - at[0].y.exact()) -
        (at[2].x.exact() - at[0].x.exact()) * (at[1].y.exact() - at[0].y.exact());
    RC_ASSERT(orientation(at[0], at[1], at[2]) == sgn(area));
    RC_PRE(sgn(area) != 0);

    const double one_rounding = *rc::gen::element(0.0, 0x1p-53, 0x1p-24);
    const CanvasSamples grid{small_canvas, moved, one_rounding};
    const TriangleSamples samples(at, grid);

    // As docs/stats.md has it: 32 roundings of a product of the box's sides, and four of a coordinate, along a side.
    const auto [left, right] = std::minmax({at[0].x, at[1].x, at[2].x});
    const auto [low, high] = std::minmax({at[0].y, at[1].y, at[2].y});
    const double width = right.nearest() - left.nearest();
    const double height = high.nearest() - low.nearest();
    const double farthest = std::max({std::abs(left.nearest()), std::abs(right.nearest()),
                                      std::abs(low.nearest()), std::abs(high.nearest())});
    const mpq_class error =
        1.001 * one_rounding * (32 * width * height + 4 * (width + height) * farthest);

    for (int y = 0; y < small_canvas.height; ++y) {
        const auto row = samples.row(y);
        for (int x = 0; x < small_canvas.width; ++x) {
            const Expected expected =
                expected_at(at, sgn(area), error, offset.x_of(x), offset.y_of(y));
            RC_ASSERT(row.inside.has(x) == expected.inside);
            RC_ASSERT(row.within_error.has(x) == expected.within_error);
        }
    }

    // No row with a sample in the triangle is left out, nor many others looked at.
    const Span rows = grid.rows_about(low, high);
    for (int y = 0; y < small_canvas.height; ++y) {
        const mpq_class sample_y = offset.y_of(y);
        if (low.exact() <= sample_y && sample_y <= high.exact())
            RC_ASSERT(rows.has(small_canvas.row_of(y)));
        if (sample_y < low.exact() - 4 || high.exact() + 4 < sample_y)
            RC_ASSERT(!rows.has(small_canvas.row_of(y)));
    }
}

} // namespace
} // namespace rastertrace
