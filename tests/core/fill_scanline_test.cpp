// SPDX-License-Identifier: MIT
#include "picture.h"
#include "random_triangle.h"

#include <gtest/gtest.h>

#include <rapidcheck.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <map>
#include <optional>
#include <string>
#include <vector>

namespace rastertrace {
namespace {

// ---- The worked example (sources.md, T0) -----------------------------------------------------

struct Row {
    int y;
    std::string left, right;
    Index from, to;

    friend bool operator==(const Row&, const Row&) = default;
    friend std::ostream& operator<<(std::ostream& out, const Row& row) {
        return out << row.y << ": " << row.left << " " << row.right << " -> " << row.from << ".."
                   << row.to;
    }
};

/// Keeps the rows, with their ends as fractions in lowest terms.
struct RowRecorder {
    std::vector<Row> rows;

    void operator()(const ScanlineSpanned<>& step) {
        rows.push_back({step.y, step.left.text(), step.right.text(), step.from, step.to});
    }
};

TEST(FirstTriangle, HasTheRowsOfTheTextbook) {
    RowRecorder recorder;
    draw_as_planned(first_triangle(), recorder);
    const std::vector<Row> expected{
        {5, "2", "2", 2, 2},         {4, "5/4", "19/8", 1, 2},     {3, "1/2", "11/4", 0, 2},
        {2, "-1/4", "25/8", -1, 3},  {1, "-1", "7/2", -1, 3},      {0, "-7/4", "31/8", -2, 3},
        {-1, "-5/2", "17/4", -3, 4}, {-2, "-13/4", "37/8", -4, 4}, {-3, "-4", "5", -4, 5}};
    EXPECT_EQ(recorder.rows, expected);
}

TEST(FirstTriangle, IsThePictureOfTheTextbook) {
    EXPECT_EQ(picture_of(draw_as_planned(first_triangle())), textbook_picture);
    EXPECT_EQ(picture_of(draw_as_planned(first_triangle({}))), textbook_picture) << "in double";
}

TEST(FirstTriangle, HasThePixelsThatEachRoundingGives) {
    // 49, 45, 49, 50 and 43 pixels. Those of `inside` are the lattice points of the closed triangle: by
    // Pick's theorem 31 inside and 12 on edges.
    const auto picture = [](Rounding rounding, Ties ties) {
        return picture_of(draw_as_planned(small_first_triangle(
            {.scalar = ScalarKind::exact, .rounding = rounding, .ties = ties})));
    };
    // floor, truncate, nearest (a half up), nearest (a half to even), inside
    EXPECT_EQ(
        side_by_side({picture(Rounding::floor, Ties::up), picture(Rounding::truncate, Ties::up),
                      picture(Rounding::nearest, Ties::up), picture(Rounding::nearest, Ties::even),
                      picture(Rounding::inside, Ties::up)}),
        ".......#...  .......#...  .......#...  .......#...  .......#...\n"
        "......##...  ......##...  ......##...  ......##...  .......#...\n"
        ".....###...  .....###...  ......###..  .....####..  ......##...\n"
        "....#####..  .....####..  .....####..  .....####..  .....####..\n"
        "....#####..  ....#####..  ....######.  ....######.  ....#####..\n"
        "...######..  ....#####..  ...#######.  ...#######.  ....#####..\n"
        "..########.  ...#######.  ...#######.  ...#######.  ...#######.\n"
        ".#########.  ..########.  ..#########  ..#########  ..########.\n"
        ".##########  .##########  .##########  .##########  .##########\n"
        "...........  ...........  ...........  ...........  ...........\n");
}

TEST(FirstTriangle, HasThePixelsOfHalfOpenRows) {
    // 41 in all (sources.md, T0): no row has a pixel at its right end, and its top row, one point, has none.
    const Image picture = draw_as_planned(
        small_first_triangle({.scalar = ScalarKind::exact, .rounding = Rounding::half_open}));
    EXPECT_EQ(picture.drawn(), 41u);
    EXPECT_EQ(picture_of(picture), "...........\n"
                                   ".......#...\n"
                                   "......##...\n"
                                   ".....####..\n"
                                   "....#####..\n"
                                   "....#####..\n"
                                   "...#######.\n"
                                   "..########.\n"
                                   ".#########.\n"
                                   "...........\n");
}

TEST(FirstTriangle, LooksTheSameFromEveryOrigin) {
    const std::vector<std::string> shifted{"10", "11", "4", "3", "13", "3"}; // by (8, 6)
    EXPECT_EQ(picture_of(draw_as_planned(triangle_scene(
                  shifted, {.width = 17, .height = 14, .origin = Origin::bottom_left}))),
              textbook_picture);
    const std::vector<std::string> flipped{"10", "2", "4", "10", "13", "10"}; // y = 13 - y
    EXPECT_EQ(picture_of(draw_as_planned(triangle_scene(
                  flipped, {.width = 17, .height = 14, .origin = Origin::top_left}))),
              textbook_picture);
}

// ---- Shapes -----------------------------------------------------------------------------------

std::string picture_in(int width, int height, const std::vector<std::string>& coordinates,
                       Method method = {.scalar = ScalarKind::exact}) {
    return picture_of(draw_as_planned(triangle_scene(
        coordinates, {.width = width, .height = height, .origin = Origin::bottom_left}, method)));
}

TEST(Shapes, FlatTopAndFlatBottom) {
    EXPECT_EQ(side_by_side({picture_in(5, 3, {"0", "2", "4", "2", "2", "0"}),
                            picture_in(5, 3, {"0", "0", "4", "0", "2", "2"})}),
              "#####  ..#..\n"
              ".###.  .###.\n"
              "..#..  #####\n");
}

TEST(Shapes, LongEdgeOnTheLeftAndOnTheRight) {
    EXPECT_EQ(side_by_side({picture_in(4, 5, {"0", "0", "3", "2", "0", "4"}),
                            picture_in(4, 5, {"3", "0", "0", "2", "3", "4"})}),
              "#...  ...#\n"
              "##..  .###\n"
              "####  ####\n"
              "##..  .###\n"
              "#...  ...#\n");
}

TEST(Shapes, WithoutArea) {
    // numerics.md, S9: a flat triangle of 11 pixels, a point, a sloped line; and a vertical one.
    for (const ScalarKind scalar : {ScalarKind::exact, ScalarKind::double_precision})
        EXPECT_EQ(
            plots_in(lettered_triangles({{'F', {"1", "0", "11", "0", "5", "0"}},
                                         {'P', {"3", "6", "3", "6", "3", "6"}},
                                         {'S', {"0", "0", "3", "3", "7", "7"}},
                                         {'V', {"10", "2", "10", "7", "10", "4"}}},
                                        {.width = 12, .height = 8, .origin = Origin::bottom_left},
                                        {.scalar = scalar}))
                .owners,
            ".......S..V.\n"
            "...P..S...V.\n"
            ".....S....V.\n"
            "....S.....V.\n"
            "...S......V.\n"
            "..S.......V.\n"
            ".S..........\n"
            "SFFFFFFFFFFF\n");
}

TEST(Shapes, BetweenTwoRowsThereIsNothing) {
    // numerics.md, S8
    std::vector<SkipReason> reasons;
    const auto recorder = [&reasons]<typename Step>(const Step& step) {
        if constexpr (std::same_as<Step, PrimitiveSkipped<>>)
            reasons.push_back(step.why);
    };
    const Image image = draw_as_planned(
        triangle_scene({"1/10", "1/5", "53/10", "4/5", "2", "9/10"}, {.width = 16, .height = 8}),
        recorder);
    EXPECT_EQ(image.drawn(), 0u);
    EXPECT_EQ(reasons, std::vector{SkipReason::between_rows});
}

TEST(Shapes, SharedEdgeIsDrawnTwiceByTheInclusiveRule) {
    // numerics.md, S10: a square split on its diagonal. 45 + 45 pixels, 9 of them twice.
    const Plots plots = plots_in(lettered_triangles(
        {{'R', {"0", "0", "8", "0", "8", "8"}}, {'U', {"0", "0", "8", "8", "0", "8"}}},
        {.width = 9, .height = 9, .origin = Origin::bottom_left}));
    EXPECT_EQ(side_by_side({plots.owners, plots.counts}), "UUUUUUUUU  111111112\n"
                                                          "UUUUUUUUR  111111121\n"
                                                          "UUUUUUURR  111111211\n"
                                                          "UUUUUURRR  111112111\n"
                                                          "UUUUURRRR  111121111\n"
                                                          "UUUURRRRR  111211111\n"
                                                          "UUURRRRRR  112111111\n"
                                                          "UURRRRRRR  121111111\n"
                                                          "URRRRRRRR  211111111\n");
}

// ---- Stiff and extreme (numerics.md, S) -------------------------------------------------------

TEST(Stiff, TenthsAddUpToOneOnlyWhenExact) {
    // S3: the last row of (0,0) (1,10) (5,10) is [1,5]; adding 1/10 ten times in double gives
    // [0,5].
    const auto last_row = [](ScalarKind scalar, LerpForm lerp) {
        const Image image =
            draw_as_planned(triangle_scene({"0", "0", "1", "10", "5", "10"},
                                           {.width = 6, .height = 11, .origin = Origin::top_left},
                                           {.scalar = scalar, .lerp = lerp}));
        return picture_of(image).substr(7 * 10, 6);
    };
    EXPECT_EQ(last_row(ScalarKind::exact, LerpForm::direct), ".#####");
    EXPECT_EQ(last_row(ScalarKind::exact, LerpForm::incremental), ".#####");
    EXPECT_EQ(last_row(ScalarKind::double_precision, LerpForm::direct), ".#####");
    EXPECT_EQ(last_row(ScalarKind::double_precision, LerpForm::incremental), "######");
}

TEST(Stiff, AccumulatingDoubleGoesWrongOn409RowsOf3001) {
    // S4: edge (0,0)-(1000,3000), x exact at every third row; floor(y/3).
    const auto wrong_rows = [](ScalarKind scalar, LerpForm lerp) {
        int wrong = 0;
        const auto count = [&wrong]<typename Step>(const Step& step) {
            if constexpr (requires { step.left_edge; })
                wrong += step.from != step.y / 3 ? 1 : 0;
        };
        draw_as_planned(triangle_scene({"0", "0", "1000", "3000", "1200", "3000"},
                                       {.width = 1300, .height = 3001, .origin = Origin::top_left},
                                       {.scalar = scalar, .lerp = lerp}),
                        count);
        return wrong;
    };
    EXPECT_EQ(wrong_rows(ScalarKind::exact, LerpForm::incremental), 0);
    EXPECT_EQ(wrong_rows(ScalarKind::double_precision, LerpForm::direct), 0);
    EXPECT_EQ(wrong_rows(ScalarKind::double_precision, LerpForm::incremental), 409);
}

TEST(Stiff, SubnormalLeftOfZeroIsFloored) {
    // S12: (-2^-149, 0) (2, 0) (0, 2), rows [-1,2] [-1,1] [0,0]
    const std::string tiny = "-1/713623846352979940529142984724747568191373312";
    for (const ScalarKind scalar : {ScalarKind::exact, ScalarKind::double_precision})
        EXPECT_EQ(
            picture_of(draw_as_planned(triangle_scene(
                {tiny, "0", "2", "0", "0", "2"}, {.width = 5, .height = 5}, {.scalar = scalar}))),
            "..#..\n"
            ".###.\n"
            ".####\n"
            ".....\n"
            ".....\n");
}

/// Counts steps by type.
struct StepCounter {
    std::size_t rows = 0, pixels = 0, others = 0;
    template <typename Step> void operator()(const Step& step) {
        if constexpr (requires { step.left_edge; })
            ++rows;
        else if constexpr (std::same_as<Step, PixelPlotted<>>)
            ++pixels;
        else
            ++others;
    }
};

TEST(Extreme, CostFollowsTheCanvasNotTheTriangle) {
    // S11: 2,000,000,001 rows on a canvas of 64; S7: 3,000,000 pixels on a row.
    for (const ScalarKind scalar : {ScalarKind::exact, ScalarKind::double_precision}) {
        StepCounter tall;
        draw_as_planned(triangle_scene({"0", "-1e9", "1e9", "1e9", "-1e9", "1e9"},
                                       {.width = 64, .height = 64}, {.scalar = scalar}),
                        tall);
        EXPECT_EQ(tall.rows, 64u);
        EXPECT_EQ(tall.pixels, 64u * 64u);
        EXPECT_LE(tall.others, 4u + 2u + 2u * 64u);

        StepCounter wide;
        draw_as_planned(triangle_scene({"0", "0", "3000000", "1", "-3000000", "1"},
                                       {.width = 64, .height = 64, .origin = Origin::bottom_left},
                                       {.scalar = scalar}),
                        wide);
        EXPECT_EQ(wide.rows, 2u);
        EXPECT_EQ(wide.pixels, 1u + 64u);
    }
}

TEST(Extreme, FarCoordinatesAreClippedBeforeTheyAreCast) {
    for (const ScalarKind scalar : {ScalarKind::exact, ScalarKind::double_precision}) {
        const Image image =
            draw_as_planned(triangle_scene({"-1e30", "-1e30", "3e30", "-1e30", "-1e30", "3e30"},
                                           {.width = 64, .height = 64}, {.scalar = scalar}));
        EXPECT_EQ(image.drawn(), 4096u);
    }
}

TEST(Extreme, WhatMissesTheCanvasIsSkipped) {
    const Canvas canvas{.width = 16, .height = 16};
    for (const auto& coordinates :
         std::vector<std::vector<std::string>>{{"20", "0", "30", "1", "25", "7"},
                                               {"-20", "0", "-30", "1", "-25", "7"},
                                               {"0", "20", "1", "30", "7", "25"},
                                               {"0", "-20", "1", "-30", "7", "-25"}}) {
        StepCounter counter;
        draw_as_planned(triangle_scene(coordinates, canvas), counter);
        EXPECT_EQ(counter.rows + counter.pixels, 0u);
        EXPECT_EQ(counter.others, 5u) << "primitive, three edges, skip";
    }
}

// ---- Properties -------------------------------------------------------------------------------

/// Corners a little beyond the canvas, on whole numbers or halves, where ends often tie between two
/// pixels, or on a grid of 1/12 of a pixel.
std::vector<std::string> triangle_coordinates() {
    const auto parts = *rc::gen::element<std::int64_t>(1, 2, 12);
    return any_triangle(25 * parts / 2, parts);
}

rc::Gen<Canvas> small_canvas() {
    return rc::gen::map(
        rc::gen::tuple(rc::gen::inRange(1, 22), rc::gen::inRange(1, 22),
                       rc::gen::element(Origin::center, Origin::bottom_left, Origin::top_left)),
        [](const auto& all) {
            return Canvas{std::get<0>(all), std::get<1>(all), std::get<2>(all)};
        });
}

rc::Gen<Method> exact_method() {
    return rc::gen::map(
        rc::gen::tuple(rc::gen::element(Rounding::floor, Rounding::nearest, Rounding::truncate,
                                        Rounding::inside),
                       rc::gen::element(Ties::start, Ties::up, Ties::away, Ties::even),
                       rc::gen::element(LerpForm::direct, LerpForm::incremental)),
        [](const auto& all) {
            return Method{.scalar = ScalarKind::exact,
                          .rounding = std::get<0>(all),
                          .ties = std::get<1>(all),
                          .lerp = std::get<2>(all)};
        });
}

struct Meeting {
    mpq_class left, right;
};

/// Where a row meets a triangle, found without sorting, joining or walking: the smallest and the
/// largest x of all points that the row has in common with the three sides.
std::optional<Meeting> meeting(const Scene& scene, int y) {
    std::vector<mpq_class> points;
    for (std::size_t i = 0; i < 3; ++i) {
        const SceneVertex& a = scene.vertices[i];
        const SceneVertex& b = scene.vertices[(i + 1) % 3];
        const mpq_class ax = a.x.exact(), ay = a.y.exact(), bx = b.x.exact(), by = b.y.exact();
        if (ay == by) {
            if (ay == y)
                points.insert(points.end(), {ax, bx});
            continue;
        }
        const mpq_class t = (y - ay) / (by - ay);
        if (t >= 0 && t <= 1)
            points.push_back(ax + t * (bx - ax));
    }
    if (points.empty())
        return std::nullopt;
    return Meeting{*std::min_element(points.begin(), points.end()),
                   *std::max_element(points.begin(), points.end())};
}

/// The rounding rules once more, in the words of rounding.h.
long rounded(const mpq_class& x, const Method& method, bool is_left) {
    const auto floor_of = [](const mpq_class& value) {
        mpz_class quotient;
        mpz_fdiv_q(quotient.get_mpz_t(), value.get_num_mpz_t(), value.get_den_mpz_t());
        return quotient.get_si();
    };
    const long below = floor_of(x);
    const long above = -floor_of(-x);
    switch (*method.rounding) {
    case Rounding::floor:
        return below;
    case Rounding::truncate:
        return x < 0 ? above : below;
    case Rounding::inside:
        return is_left ? above : below;
    case Rounding::half_open:
        return is_left ? above : above - 1;
    case Rounding::nearest:
        break;
    }
    const mpq_class to_below = x - below, to_above = above - x;
    if (to_below != to_above)
        return to_below < to_above ? below : above;
    switch (*method.ties) {
    case Ties::start:
        return below;
    case Ties::up:
    case Ties::step: // of lines only
        return above;
    case Ties::away:
        return x < 0 ? below : above;
    case Ties::even:
        break;
    }
    return below % 2 == 0 ? below : above;
}

std::string picture_by_the_rule(const Scene& scene) {
    Image image(scene.canvas);
    for (int row = 0; row < scene.canvas.height; ++row) {
        const int y = scene.canvas.y_of(row);
        const auto ends = meeting(scene, y);
        if (!ends)
            continue;
        for (int x = scene.canvas.left(); x <= scene.canvas.right(); ++x)
            if (rounded(ends->left, scene.method, true) <= x &&
                x <= rounded(ends->right, scene.method, false))
                image.at({x, y}) = Color{};
    }
    return picture_of(image);
}

RC_GTEST_PROP(ScanlineFill, DrawsWhatTheRuleSays, ()) {
    const Scene scene = triangle_scene(triangle_coordinates(), *small_canvas(), *exact_method());
    log_scene(scene);
    RC_ASSERT(picture_of(draw_as_planned(scene)) == picture_by_the_rule(scene));
}

RC_GTEST_PROP(ScanlineFill, DrawsTheSameWithEveryExactType, ()) {
    const Scene scene = triangle_scene(triangle_coordinates(), *small_canvas(), *exact_method());
    log_scene(scene);
    const Plan plan = plan_for(scene);
    RC_ASSERT(plan.number == NumberType::fraction64);
    const std::string picture = picture_of(draw(scene, plan));
    RC_ASSERT(picture_of(draw_with(NumberType::rational, scene)) == picture);
}

RC_GTEST_PROP(ScanlineFill, DrawsTheSamePixelsForEveryVertexOrder, ()) {
    Method method = *exact_method();
    method.scalar = *rc::gen::element(ScalarKind::exact, ScalarKind::double_precision);
    Scene scene = triangle_scene(triangle_coordinates(), *small_canvas(), method);
    log_scene(scene);
    const std::string picture = picture_of(draw_as_planned(scene));
    auto& order = scene.primitives[0].vertices;
    while (std::next_permutation(order.begin(), order.end()))
        RC_ASSERT(picture_of(draw_as_planned(scene)) == picture);
}

RC_GTEST_PROP(ScanlineFill, InDoubleIsWrongOnlyWhereAnEndIsNextToAPixel, ()) {
    // The fill computes an end with five roundings from coordinates below 16: 16 ulps of 16 is a
    // generous bound. Where an exact end is farther than that from every pixel, double decides
    // alike.
    const mpq_class bound(1, std::int64_t{1} << 44);
    Scene scene = triangle_scene(triangle_coordinates(), {.width = 32, .height = 32});
    scene.method.scalar = ScalarKind::double_precision;
    scene.method.rounding = Rounding::floor;
    log_scene(scene);
    std::map<int, std::pair<Index, Index>> spans;
    const auto keep = [&spans]<typename Step>(const Step& step) {
        if constexpr (requires { step.left_edge; })
            spans[step.y] = {step.from, step.to};
    };
    draw_as_planned(scene, keep);

    for (int y = scene.canvas.bottom(); y <= scene.canvas.top(); ++y) {
        const auto ends = meeting(scene, y);
        RC_ASSERT(ends.has_value() == (spans.count(y) == 1));
        if (!ends)
            continue;
        const auto agrees = [&](const mpq_class& x, Index found) {
            const long low = rounded(x - bound, scene.method, true);
            const long high = rounded(x + bound, scene.method, true);
            return low <= found && found <= high;
        };
        RC_ASSERT(agrees(ends->left, spans[y].first));
        RC_ASSERT(agrees(ends->right, spans[y].second));
    }
}

RC_GTEST_PROP(ScanlineFill, OnASmallCanvasIsACutOfTheLargePicture, ()) {
    const auto coordinates = triangle_coordinates();
    const Method method = *exact_method();
    const Image whole =
        draw_as_planned(triangle_scene(coordinates, {.width = 41, .height = 41}, method));
    const Canvas small{.width = *rc::gen::inRange(1, 20), .height = *rc::gen::inRange(1, 20)};
    const Scene cut = triangle_scene(coordinates, small, method);
    log_scene(cut);
    const Image part = draw_as_planned(cut);
    for (int row = 0; row < small.height; ++row)
        for (int x = small.left(); x <= small.right(); ++x) {
            const Pixel pixel{x, small.y_of(row)};
            RC_ASSERT(part.at(pixel) == whole.at(pixel));
        }
}

RC_GTEST_PROP(ScanlineFill, ReportsEveryPixelOfThePictureAndOfTheRest, ()) {
    // The pixel steps are the picture; with the rejected runs they are the whole spans.
    const Scene scene = triangle_scene(triangle_coordinates(), *small_canvas(), *exact_method());
    log_scene(scene);
    Image replayed(scene.canvas);
    Index in_spans = 0, plotted = 0, rejected = 0;
    const auto sink = [&]<typename Step>(const Step& step) {
        if constexpr (std::same_as<Step, PixelPlotted<>>) {
            replayed.at(step.pixel()) = step.color;
            ++plotted;
        } else if constexpr (std::same_as<Step, PixelsRejected<>>) {
            rejected += step.x ? step.to_x.value_or(*step.x) - *step.x + 1 : 0;
        } else if constexpr (requires { step.left_edge; }) {
            in_spans += std::max<Index>(0, step.to - step.from + 1);
        }
    };
    const Image image = draw_as_planned(scene, sink);
    RC_ASSERT(image.colors() == replayed.colors());
    RC_ASSERT(image.colors() == draw_as_planned(scene).colors());
    RC_ASSERT(plotted + rejected == in_spans);
}

} // namespace
} // namespace rastertrace
