// SPDX-License-Identifier: MIT
#include "picture.h"
#include "random_triangle.h"

#include <gtest/gtest.h>

#include <rapidcheck.h>
#include <rapidcheck/gtest.h>

#include <string>

namespace rastertrace {
namespace {

Plan plan_of(const std::vector<std::string>& coordinates,
             Method method = {.scalar = ScalarKind::exact}) {
    return plan_for(triangle_scene(coordinates, {.width = 64, .height = 64}, method));
}

TEST(Plan, TakesTheNarrowestExactType) {
    EXPECT_EQ(plan_of({"2", "5", "-4", "-3", "5", "-3"}).number, NumberType::fraction64);
    EXPECT_EQ(plan_of({"0.5", "5", "-4", "-3.25", "5", "1/3"}).number, NumberType::fraction64);
    EXPECT_EQ(plan_of({"0", "-1e9", "1e9", "1e9", "-1e9", "1e9"}).number, NumberType::rational);
    EXPECT_EQ(plan_of({"0", "0", "1e30", "1", "2", "3"}).number, NumberType::rational);
    EXPECT_EQ(plan_of({"0", "0", "1e-30", "1", "2", "3"}).number, NumberType::rational);
    EXPECT_EQ(
        plan_of({"1/2305843009213693951", "0", "1/2305843009213693953", "1", "2", "3"}).number,
        NumberType::rational)
        << "the common denominator does not fit";
    EXPECT_EQ(plan_of({"2", "5", "-4", "-3", "5", "-3"}, {}).number, NumberType::binary64);
}

TEST(Plan, WritesAllNumbersOverOneDenominator) {
    EXPECT_EQ(plan_of({"0.5", "5", "-4", "-3.25", "5", "1/3"}).denominator, 300)
        << "tenths and hundredths as typed, and a third";
}

RC_GTEST_PROP(Plan, NeverLetsAFractionOverflow, ()) {
    // Numbers of every size, so that both sides of each limit are met. The undefined-behavior
    // sanitizer watches the fractions; the rationals say what the picture is.
    const int bits = *rc::gen::inRange(1, 62);
    const auto denominator = *rc::gen::inRange<std::int64_t>(1, 5000);
    const std::int64_t largest = std::int64_t{1} << bits;
    const Method method{.scalar = ScalarKind::exact,
                        .rounding = *rc::gen::element(Rounding::floor, Rounding::nearest),
                        .lerp = *rc::gen::element(LerpForm::direct, LerpForm::incremental)};
    const Scene scene =
        triangle_scene(any_triangle(largest, denominator), {.width = 32, .height = 32}, method);
    log_scene(scene);
    RC_TAG(static_cast<int>(plan_for(scene).number));
    RC_ASSERT(draw_as_planned(scene).colors() == draw_with(NumberType::rational, scene).colors());
}

// Nothing can hide a triangle that is alone and is not cut, in whatever numbers; a camera turned by 30 degrees and
// a field of view of 60 make the intervals of `adaptive` wider than a last place.
RC_GTEST_PROP(Plan, LeavesOutTheDepthsOfATriangleThatIsAlone, ()) {
    const auto tenths = [](int low, int high) {
        return Number::decimal(*rc::gen::inRange(low, high), -1);
    };
    Scene scene = triangle_scene({"0", "0", "0", "0", "0", "0"}, {.width = 32, .height = 32}, {});
    for (SceneVertex& vertex : scene.vertices)
        vertex = {vertex.name, tenths(-10, 10), tenths(-10, 10), {}, tenths(-20, 20)};
    scene.projection = {.type = ProjectionType::frustum,
                        .fov_y = 60,
                        .near = Number::decimal(1, -1),
                        .far = Number(100)};
    scene.viewport = {.type = ViewportType::pixels};
    scene.camera = Camera{.position = {3, 3, 9}, .look_at = {0, 0, 0}};
    scene.method.fill = Fill::top_left;
    scene.method.depth = *rc::gen::element(Depth::inverse_z, Depth::linear_z, Depth::ndc_z);
    const auto tests_depth = [&scene](ScalarKind scalar) {
        scene.method.scalar = scalar;
        return plan_for(scene).stages.pixels[0].tests_depth;
    };
    RC_PRE(!tests_depth(ScalarKind::double_precision));
    RC_ASSERT(!tests_depth(ScalarKind::adaptive));
}

TEST(Unfit, OfACoordinateIsFound) {
    const auto unfit = find_unfit(
        triangle_scene({"0", "0", "1", "1", "-1e308", "2"}, {.width = 4, .height = 4}, {}));
    ASSERT_TRUE(unfit);
    EXPECT_EQ(unfit->what, Unfit::What::coordinate);
    EXPECT_EQ(unfit->from, 2u);
}

TEST(Unfit, OfASlopeIsFound) {
    const auto unfit = find_unfit(
        triangle_scene({"0", "0", "1", "1e-320", "0", "2"}, {.width = 4, .height = 4}, {}));
    ASSERT_TRUE(unfit);
    EXPECT_EQ(unfit->what, Unfit::What::slope);
    EXPECT_EQ(unfit->from, 0u);
    EXPECT_EQ(unfit->to, 1u);
}

TEST(Unfit, WeightsThatWouldBeInfiniteAreFound) {
    const auto what = [](const std::vector<std::string>& coordinates, Fill fill) {
        const auto unfit =
            find_unfit(triangle_scene(coordinates, {.width = 4, .height = 4}, {.fill = fill}));
        return unfit ? std::optional(unfit->what) : std::nullopt;
    };
    const std::vector<std::string> huge{"0", "0", "1e200", "1", "3", "1e200"};
    const std::vector<std::string> thin{"0", "0", "1", "1", "1e-310", "0"};
    for (const Fill fill : {Fill::barycentric, Fill::top_left}) {
        EXPECT_EQ(what(huge, fill), Unfit::What::coordinate_of_weights);
        EXPECT_EQ(what(thin, fill), Unfit::What::area_of_weights);
    }
    EXPECT_EQ(what(huge, Fill::scanline), std::nullopt);
    EXPECT_EQ(what(thin, Fill::scanline), std::nullopt);
}

TEST(Unfit, CannotHappenToExactNumbers) {
    const Scene scene =
        triangle_scene({"0", "0", "1", "1e-320", "-1e308", "2"}, {.width = 8, .height = 8});
    EXPECT_FALSE(find_unfit(scene));
    EXPECT_EQ(picture_of(draw_as_planned(scene)), "........\n"
                                                  "........\n"
                                                  "........\n"
                                                  "........\n"
                                                  "....#...\n"
                                                  "........\n"
                                                  "........\n"
                                                  "........\n")
        << "the rows above lie far left of the canvas";
}

} // namespace
} // namespace rastertrace
