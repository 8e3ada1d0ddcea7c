// SPDX-License-Identifier: MIT
// What is fast draws what the book's page draws.

#include <rastertrace/core/draw/paint/exact_depth_buffer.h>
#include <rastertrace/core/draw/paint/fill_top_left.h>
#include <rastertrace/core/draw/paint/row_painter.h>
#include <rastertrace/core/numbers/interval.h>
#include <rastertrace/core/numbers/rational.h>
#include <rastertrace/core/raster/flat_painter.h>

#include "fill_half_space.h"
#include "picture.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <map>
#include <optional>

namespace rastertrace {
namespace {

/// n/8, which every kind of number holds; fractions over 8.
template <typename Scalar> Scalar eighths(std::int64_t n) {
    if constexpr (is_fraction<Scalar>)
        return {n, 8};
    else
        return Scalar(scalar_from<Scalar>(n) / scalar_from<Scalar>(8));
}

/// The pixels of both fills, drawn in numbers of one kind.
struct TwoPictures {
    Image by_rows;
    Image by_half_spaces;
};
template <typename Scalar>
TwoPictures pictures_of(const std::array<std::int64_t, 6>& at,
                        const std::array<std::int64_t, 2>& sample, const Canvas& canvas) {
    const Triangle<Scalar> triangle{{{{eighths<Scalar>(at[0]), eighths<Scalar>(at[1])},
                                      {eighths<Scalar>(at[2]), eighths<Scalar>(at[3])},
                                      {eighths<Scalar>(at[4]), eighths<Scalar>(at[5])}}}};
    const SampleOffset<Scalar> offset(eighths<Scalar>(sample[0]), eighths<Scalar>(sample[1]));
    TwoPictures pictures{Image(canvas), Image(canvas)};
    fill_top_left(triangle, SampleGrid<Scalar>(offset, canvas), canvas,
                  FlatPainter(pictures.by_rows, Color{255, 0, 0}));
    fill_half_space(triangle, offset, canvas,
                    FlatPainter(pictures.by_half_spaces, Color{255, 0, 0}));
    return pictures;
}

template <typename Scalar> class HalfSpace : public testing::Test {};
using EveryScalar = testing::Types<float, double, Fraction64, Rational, Interval>;
TYPED_TEST_SUITE(HalfSpace, EveryScalar);

TYPED_TEST(HalfSpace, HasThePixelsThatTheTopLeftFillFindsRowByRow) {
    int decided = 0;
    const bool holds = rc::check([&decided] {
        const Canvas canvas{
            .width = 13,
            .height = 11,
            .origin = *rc::gen::element(Origin::center, Origin::bottom_left, Origin::top_left)};
        const auto place = rc::gen::element<std::int64_t>(-8, 0, 1, 4, 7, 8);
        const std::array<std::int64_t, 2> offset{*place, *place};
        // An interval leaves open whether a sample lies on an edge: three triangles, so that enough
        // of them are decided.
        for (int triangle = 0; triangle < 3; ++triangle) {
            std::array<std::int64_t, 6> at{};
            for (std::int64_t& coordinate : at)
                coordinate = *rc::gen::inRange<std::int64_t>(-80, 120);
            try {
                const auto [by_rows, by_half_spaces] = pictures_of<TypeParam>(at, offset, canvas);
                ++decided;
                RC_ASSERT(picture_of(by_half_spaces) == picture_of(by_rows));
            } catch (const Undecided&) {
            }
        }
    });
    EXPECT_TRUE(holds);
    EXPECT_GT(decided, 50);
}

template <typename Scalar> class PlaneOfDepths : public testing::Test {};
using ScalarsWithRoundedDepths = testing::Types<float, double, Fraction64>;
TYPED_TEST_SUITE(PlaneOfDepths, ScalarsWithRoundedDepths);

TYPED_TEST(PlaneOfDepths, IsPaintedByPlanePainterAsByRowPainter) {
    using D = DepthOf<TypeParam>;
    const bool holds = rc::check([] {
        const Canvas canvas{.width = 13, .height = 11, .origin = Origin::center};
        const DepthRegion region{
            .left = canvas.left(), .top_row = 0, .width = canvas.width, .height = canvas.height};
        Image fast(canvas);
        Image plain(canvas);
        DepthTests<D> fast_tests(region, {});
        DepthTests<D> plain_tests(region, {});
        const SampleGrid<TypeParam> grid({eighths<TypeParam>(4), eighths<TypeParam>(4)}, canvas);
        for (std::uint8_t red = 1; red < 5; ++red) {
            Triangle<TypeParam> triangle;
            std::array<D, 3> depths{};
            for (std::size_t i = 0; i < 3; ++i) {
                triangle.vertices[i] = {eighths<TypeParam>(*rc::gen::inRange(-80, 120)),
                                        eighths<TypeParam>(*rc::gen::inRange(-80, 120))};
                depths[i] = static_cast<D>(*rc::gen::inRange(1, 9)) / 7;
            }
            const Color color{red, 0, 0};
            TriangleDepth<D> depth(depth_positions(triangle), depths, false);
            const auto plane = depth.plane({D(0.5), D(0.5)});
            fill_top_left(triangle, grid, canvas,
                          PlanePainter<TypeParam>(fast, color, plane, fast_tests));
            fill_top_left(
                triangle, grid, canvas,
                RowPainter<TypeParam>{
                    .image = plain, .flat = color, .tests = &plain_tests, .plane = &plane});
        }
        RC_ASSERT(fast.colors() == plain.colors());
        RC_ASSERT(std::equal(fast_tests.row_from(canvas.left(), 0),
                             fast_tests.row_from(canvas.left(), 0) + region.area(),
                             plain_tests.row_from(canvas.left(), 0)));
    });
    EXPECT_TRUE(holds);
}

TEST(DepthBuffers, OfExactDepthsKeepTheNearestOfAnySize) {
    const bool holds = rc::check([](bool larger_passes, bool is_cleared) {
        const DepthRegion region{.left = -1, .top_row = 2, .width = 3, .height = 2};
        DepthRule<Rational> rule{.larger_passes = larger_passes, .cleared = {}};
        if (is_cleared)
            rule.cleared = Rational(1, 2);
        ExactDepthBuffer buffer(region, rule);
        std::map<std::size_t, Rational> nearest; // not turned
        const Rational huge(mpz_class("123456789012345678901234567890"));
        for (int i = 0; i < 40; ++i) {
            const int x = *rc::gen::inRange(-1, 2);
            const int row = *rc::gen::inRange(2, 4);
            Rational depth(*rc::gen::inRange(-9, 10), *rc::gen::inRange(1, 9));
            depth.canonicalize();
            if (*rc::gen::arbitrary<bool>()) // in numerator and denominator no machine word has
                depth = (depth * huge + 1) / huge;
            auto& cell = *buffer.row_from(x, row);
            const auto known = nearest.find(buffer.index_of(cell));
            const auto stored =
                known != nearest.end() ? std::optional(known->second) : rule.cleared;
            RC_ASSERT(buffer.stored(cell) == stored);
            const bool is_nearer = !stored || (larger_passes ? depth > *stored : depth < *stored);
            const bool is_hidden = stored && depth != *stored && !is_nearer;
            const Rational turned = buffer.turned(depth);
            RC_ASSERT(buffer.hides(cell, turned) == is_hidden);
            RC_ASSERT(buffer.is_nearer(cell, turned) == is_nearer);
            RC_ASSERT(buffer.keep_if_nearer(cell, turned) == is_nearer);
            if (is_nearer)
                nearest[buffer.index_of(cell)] = depth;
        }
    });
    EXPECT_TRUE(holds);
}

TEST(HalfSpaceFill, TellsTheEdgeFunctionsOfEachPixelOfTheBox) {
    // A(0,0), B(4,0), C(0,4), y up, samples at integers: AB is the bottom edge, AC a left one, and BC a right one.
    const Canvas canvas{.width = 6, .height = 6, .origin = Origin::bottom_left};
    Image image(canvas);
    int tested = 0;
    const auto listener = [&tested](const auto& step) {
        if constexpr (requires { step.values; }) {
            ++tested;
            // Twice the areas that the sample makes with the edges: together, that of the triangle.
            EXPECT_EQ(step.values[0] + step.values[1] + step.values[2], 16);
        }
    };
    fill_half_space(Triangle<double>{{{{0, 0}, {4, 0}, {0, 4}}}}, {}, canvas,
                    FlatPainter(image, Color{255, 0, 0}, listener));
    EXPECT_EQ(tested, 25);
    EXPECT_EQ(picture_of(image), "......\n"
                                 "......\n"
                                 "#.....\n"
                                 "##....\n"
                                 "###...\n"
                                 "......\n");
}

} // namespace
} // namespace rastertrace
