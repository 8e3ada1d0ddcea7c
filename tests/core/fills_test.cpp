// SPDX-License-Identifier: MIT
#include "picture.h"
#include "random_triangle.h"

#include <rastertrace/core/draw/paint/fill_top_left.h>
#include <rastertrace/core/draw/paint/row_painter.h>
#include <rastertrace/core/raster/flat_painter.h>

#include <gtest/gtest.h>

#include <rapidcheck.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <concepts>
#include <limits>
#include <map>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

namespace rastertrace {
namespace {

struct Counter {
    std::size_t pixels = 0, samples = 0, rows = 0;
    std::vector<bool> upper_halves;
    template <typename Step> void operator()(const Step& step) {
        if constexpr (std::same_as<Step, PixelPlotted<>>)
            ++pixels;
        else if constexpr (requires { step.weights; })
            ++samples;
        else if constexpr (requires { step.left_edge; })
            ++rows;
        else if constexpr (requires { step.half; })
            upper_halves.push_back(step.half == "upper");
    }
};

constexpr std::array every_scalar{ScalarKind::double_precision, ScalarKind::fixed,
                                  ScalarKind::exact};

// ---- A fill of somebody else ---------------------------------------------------------------------

/// Fills the box around a triangle whose vertices are whole numbers.
template <typename Scalar, typename Sink>
void fill_box(const Triangle<Scalar>& triangle, Canvas canvas, Sink&& sink) {
    const auto& [a, b, c] = triangle.vertices;
    const Index first_row =
        std::min({canvas.row_of(floor_index(a.y)), canvas.row_of(floor_index(b.y)),
                  canvas.row_of(floor_index(c.y))});
    const Index last_row =
        std::max({canvas.row_of(floor_index(a.y)), canvas.row_of(floor_index(b.y)),
                  canvas.row_of(floor_index(c.y))});
    const Scalar left = std::min({a.x, b.x, c.x});
    const Scalar right = std::max({a.x, b.x, c.x});
    const RowRange rows = rows_on_canvas(
        first_row, last_row, [] { return false; }, canvas, sink);
    for (int row = rows.begin; row < rows.end; ++row)
        sink(ScanlineSpanned<Scalar>{.y = canvas.y_of(row),
                                     .left = left,
                                     .right = right,
                                     .from = floor_index(left),
                                     .to = floor_index(right),
                                     .left_edge = {0, 1},
                                     .right_edge = {0, 2}});
}

constexpr Canvas six_by_four{.width = 6, .height = 4, .origin = Origin::top_left};

TEST(Painters, PaintTheRowsOfAnyFillAndTellItsSteps) {
    const Triangle<double> triangle{{{{3, -1}, {1, 2}, {7, 2}}}};
    Image image(six_by_four);
    std::string told;
    const auto listener = [&told](const auto& step) {
        using Step = std::remove_cvref_t<decltype(step)>;
        if constexpr (std::same_as<Step, PixelsRejected<>>)
            told += step.x ? "-" + std::to_string(step.to_x.value_or(*step.x)) + " " : "above ";
        else if constexpr (std::same_as<Step, ScanlineSpanned<double>>)
            told += "row ";
        else if constexpr (std::same_as<Step, PixelPlotted<>>)
            told += std::to_string(step.x);
    };
    fill_box(triangle, six_by_four, FlatPainter(image, Color{255, 0, 0}, listener));
    EXPECT_EQ(picture_of(image), ".#####\n"
                                 ".#####\n"
                                 ".#####\n"
                                 "......\n");
    EXPECT_EQ(told, "above row 12345-7 row 12345-7 row 12345-7 ");

    // Nobody listens: the same picture.
    Image plain(six_by_four);
    fill_box(triangle, six_by_four, FlatPainter(plain, Color{255, 0, 0}));
    EXPECT_EQ(plain.colors(), image.colors());
}

TEST(Painters, HideWhatIsFartherThanWhatAnyFillHasDrawn) {
    Image image(six_by_four);
    DepthTests<double> buffer({.left = 0, .top_row = 0, .width = 6, .height = 4},
                              {.larger_passes = true, .cleared = 0});
    const auto draw_at = [&](const Triangle<double>& triangle, double z, Color color) {
        TriangleDepth<double> depth(triangle.vertices, {1 / z, 1 / z, 1 / z},
                                    buffer.larger_passes());
        fill_box(triangle, six_by_four,
                 RowPainter<double>{.image = image,
                                    .stages = {.tests_depth = true},
                                    .flat = color,
                                    .tests = &buffer,
                                    .triangle = &depth});
    };
    const Color near{255, 0, 0}, far{0, 0, 255};
    draw_at({{{{0, 0}, {2, 1}, {1, 1}}}}, 1, near);
    draw_at({{{{1, 1}, {4, 2}, {1, 2}}}}, 2, far);
    std::string owners;
    for (int y = 0; y < 4; ++y) {
        for (int x = 0; x < 6; ++x)
            owners += image.at({x, y}) == near ? 'n' : image.at({x, y}) == far ? 'f' : '.';
        owners += '\n';
    }
    EXPECT_EQ(owners, "nnn...\n"
                      "nnnff.\n"
                      ".ffff.\n"
                      "......\n");
}

// ---- The worked triangle ------------------------------------------------------------------------

TEST(Barycentric, HasTheWeightsOfTheTable) {
    // sources.md, T3: P, its weights of A, B, C, and whether it is inside.
    struct Entry {
        int x, y;
        std::array<std::string, 3> weights;
        bool is_inside;
    };
    const std::vector<Entry> table{
        {0, 0, {"27/72", "31/72", "14/72"}, true}, {-1, 1, {"1/2", "1/2", "0"}, true},
        {1, -3, {"0", "4/9", "5/9"}, true},        {3, 2, {"5/8", "1/72", "13/36"}, true},
        {-1, 2, {"5/8", "11/24", "-1/12"}, false}, {4, 2, {"5/8", "-7/72", "17/36"}, false}};
    std::map<std::pair<int, int>, std::pair<std::array<mpq_class, 3>, bool>> found;
    const auto sink = [&found](const SampleTested<>& step) {
        std::array<mpq_class, 3> weights;
        for (std::size_t i = 0; i < 3; ++i)
            weights[i] = step.weights[i].exact();
        found[{step.x, step.y}] = {weights, step.inside};
    };
    draw_as_planned(first_triangle({.scalar = ScalarKind::exact, .fill = Fill::barycentric}), sink);
    EXPECT_EQ(found.size(), 90u);
    for (const Entry& entry : table) {
        const auto& [weights, is_inside] = found.at({entry.x, entry.y});
        for (std::size_t i = 0; i < 3; ++i)
            EXPECT_EQ(weights[i], number(entry.weights[i]).exact()) << entry.x << "," << entry.y;
        EXPECT_EQ(is_inside, entry.is_inside);
    }
}

TEST(Fills, DrawTheFirstTriangleAsTheTextsSay) {
    for (const ScalarKind scalar : every_scalar) {
        const auto picture = [scalar](Method method) {
            method.scalar = scalar;
            return picture_of(draw_as_planned(small_first_triangle(method)));
        };
        // barycentric on whole numbers (43) and on centers (36); top-left on centers (36, for none lies
        // on an edge) and on whole numbers (32: without BC and AC); a fan of three passes (50)
        EXPECT_EQ(side_by_side({picture({.fill = Fill::barycentric}),
                                picture({.fill = Fill::barycentric, .sample = Sample::center}),
                                picture({.fill = Fill::top_left}),
                                picture({.fill = Fill::top_left, .sample = Sample::integer}),
                                picture({.fill = Fill::fan, .fan_passes = 3})}),
                  ".......#...  ...........  ...........  ...........  .......#...\n"
                  ".......#...  ...........  ...........  .......#...  ......##...\n"
                  "......##...  ......##...  ......##...  ......##...  .....####..\n"
                  ".....####..  .....###...  .....###...  .....####..  .....####..\n"
                  "....#####..  ....####...  ....####...  ....#####..  ....#####..\n"
                  "....#####..  ....#####..  ....#####..  ....#####..  ...#######.\n"
                  "...#######.  ...######..  ...######..  ...#######.  ..########.\n"
                  "..########.  ..#######..  ..#######..  ..########.  ..#########\n"
                  ".##########  .#########.  .#########.  ...........  .##########\n"
                  "...........  ...........  ...........  ...........  ...........\n");

        Counter box, halves, fan;
        draw_as_planned(first_triangle({.scalar = scalar, .fill = Fill::barycentric}), box);
        EXPECT_EQ(box.samples, 90u);
        EXPECT_EQ(picture_of(draw_as_planned(
                      first_triangle({.scalar = scalar, .fill = Fill::two_halves}), halves)),
                  textbook_picture);
        EXPECT_EQ(halves.upper_halves, (std::vector{false, true})) << "lower, then upper";
        draw_as_planned(first_triangle({.scalar = scalar, .fill = Fill::fan, .fan_passes = 3}),
                        fan);
        EXPECT_EQ(fan.pixels, 242u);
    }
}

/// A triangle as a fan draws it; `o` marks a hole: a pixel of the closed triangle, as the barycentric
/// fill draws it, that the fan misses.
std::string fan_with_holes(const std::vector<std::string>& coordinates, int passes, Canvas canvas) {
    const auto picture = [&](Method method) {
        return picture_of(draw_as_planned(triangle_scene(coordinates, canvas, method)));
    };
    const std::string closed = picture({.scalar = ScalarKind::exact, .fill = Fill::barycentric});
    std::string fan =
        picture({.scalar = ScalarKind::exact, .fill = Fill::fan, .fan_passes = passes});
    for (std::size_t i = 0; i < fan.size(); ++i)
        if (closed[i] == '#' && fan[i] == '.')
            fan[i] = 'o';
    return fan;
}

TEST(Fan, HasTheHolesOfTheText) {
    // Three calls, one per edge: AB to C, CA to B, BC to A (sources.md, T4).
    const auto holes = [](const std::vector<std::string>& coordinates, int passes) {
        const std::string fan = fan_with_holes(
            coordinates, passes, {.width = 512, .height = 512, .origin = Origin::top_left});
        return std::count(fan.begin(), fan.end(), 'o');
    };
    EXPECT_EQ(holes({"100", "100", "400", "150", "250", "400"}, 1), 256);
    EXPECT_EQ(holes({"250", "400", "100", "100", "400", "150"}, 1), 2789);
    EXPECT_EQ(holes({"400", "150", "250", "400", "100", "100"}, 1), 4341);
    EXPECT_EQ(holes({"100", "100", "400", "150", "250", "400"}, 3), 0);

    // The worked triangle: 2, 3 and 0 holes, and none in all three together; those draw 7 pixels that
    // the closed triangle does not have.
    const auto first = [](const std::vector<std::string>& coordinates, int passes) {
        return fan_with_holes(coordinates, passes, small_first_triangle().canvas);
    };
    EXPECT_EQ(side_by_side({first({"2", "5", "-4", "-3", "5", "-3"}, 1),
                            first({"5", "-3", "2", "5", "-4", "-3"}, 1),
                            first({"-4", "-3", "5", "-3", "2", "5"}, 1),
                            first({"2", "5", "-4", "-3", "5", "-3"}, 3)}),
              ".......#...  .......#...  .......#...  .......#...\n"
              "......##...  ......##...  ......##...  ......##...\n"
              ".....#o##..  .....##o#..  .....####..  .....####..\n"
              ".....####..  .....#o##..  .....####..  .....####..\n"
              "....#o###..  ....#o###..  ....#####..  ....#####..\n"
              "...#######.  ...#######.  ...#######.  ...#######.\n"
              "..########.  ..########.  ..########.  ..########.\n"
              "..#########  ..#########  ..#########  ..#########\n"
              ".##########  .##########  .##########  .##########\n"
              "...........  ...........  ...........  ...........\n");
}

// ---- Edge functions on centers (numerics.md, C) -------------------------------------------------

std::size_t top_left_pixels(const std::vector<std::string>& coordinates, ScalarKind scalar,
                            int size = 64) {
    return draw_as_planned(
               triangle_scene(coordinates,
                              {.width = size, .height = size, .origin = Origin::top_left},
                              {.scalar = scalar, .fill = Fill::top_left}))
        .drawn();
}

TEST(TopLeft, SliversAndTinyTriangles) {
    for (const ScalarKind scalar : every_scalar) {
        EXPECT_EQ(top_left_pixels({"0", "1/4", "64", "3/8", "64", "5/16"}, scalar), 0u) << "C2";
        EXPECT_EQ(top_left_pixels({"0", "1/2", "64", "1/2", "64", "129/256"}, scalar), 64u) << "C3";
        EXPECT_EQ(top_left_pixels({"0", "1/2", "64", "1/2", "64", "127/256"}, scalar), 0u) << "C4";
        EXPECT_EQ(top_left_pixels({"0", "0", "64", "64", "64", "16383/256"}, scalar), 64u) << "C5";
        EXPECT_EQ(top_left_pixels({"-1e9", "-1e9", "3e9", "-1e9", "-1e9", "3e9"}, scalar), 4096u);
    }
    EXPECT_EQ(top_left_pixels({"-1e30", "-1e30", "3e30", "-1e30", "-1e30", "3e30"},
                              ScalarKind::double_precision),
              4096u)
        << "C10";
}

TEST(TopLeft, SnappingMovesADiagonalAndLeavesNothingOfATinyTriangle) {
    // C13 and C14, exact and snapped to 1/256: the diagonal moves from just beyond the centers onto
    // them, where it is a right edge; the tiny triangle becomes a point.
    const auto pictures = [](const std::vector<std::string>& coordinates, int size) {
        const auto picture = [&](ScalarKind scalar) {
            return picture_of(draw_as_planned(triangle_scene(
                coordinates, {.width = size, .height = size, .origin = Origin::top_left},
                {.scalar = scalar, .fill = Fill::top_left})));
        };
        return side_by_side({picture(ScalarKind::exact), picture(ScalarKind::fixed)});
    };
    EXPECT_EQ(pictures({"0", "0", "8", "0", "0", "8193/1024"}, 9), "########.  #######..\n"
                                                                   "#######..  ######...\n"
                                                                   "######...  #####....\n"
                                                                   "#####....  ####.....\n"
                                                                   "####.....  ###......\n"
                                                                   "###......  ##.......\n"
                                                                   "##.......  #........\n"
                                                                   "#........  .........\n"
                                                                   ".........  .........\n");
    EXPECT_EQ(pictures({"1/2", "1/2", "513/1024", "1/2", "1/2", "513/1024"}, 2), "#.  ..\n"
                                                                                 "..  ..\n");
}

TEST(TopLeft, CenterExactlyOnAnEdge) {
    // C16: pixel (4, 11) of this triangle has edge value 0, on a left edge: drawn.
    const Image image =
        draw_as_planned(triangle_scene({"53/8", "133/4", "43/4", "71/16", "55/16", "5/8"},
                                       {.width = 64, .height = 64, .origin = Origin::top_left},
                                       {.scalar = ScalarKind::fixed, .fill = Fill::top_left}));
    EXPECT_NE(image.at({4, 11}), no_color);
}

TEST(TopLeft, HubOfAFanHasOneOwner) {
    // C1: six triangles round (20.5, 20.5), here round (14.5, 12.5). The hub is the center of a pixel,
    // which the first triangle has alone. 91 77 91 77 91 77 pixels, 504 together, none twice.
    const std::string picture = ".......55555555555555........\n"
                                ".......455555555555556.......\n"
                                "......44455555555555666......\n"
                                "......44455555555555666......\n"
                                ".....4444455555555566666.....\n"
                                ".....4444455555555566666.....\n"
                                "....444444455555556666666....\n"
                                "...44444444455555666666666...\n"
                                "...44444444455555666666666...\n"
                                "..4444444444455566666666666..\n"
                                "..4444444444455566666666666..\n"
                                ".444444444444456666666666666.\n"
                                "3333333333333311111111111111.\n"
                                ".333333333333321111111111111.\n"
                                "..3333333333322211111111111..\n"
                                "..3333333333322211111111111..\n"
                                "...33333333322222111111111...\n"
                                "...33333333322222111111111...\n"
                                "....333333322222221111111....\n"
                                ".....3333322222222211111.....\n"
                                ".....3333322222222211111.....\n"
                                "......33322222222222111......\n"
                                "......33322222222222111......\n"
                                ".......322222222222221.......\n"
                                ".............................\n";
    const Canvas canvas{.width = 29, .height = 25, .origin = Origin::top_left};
    for (const ScalarKind scalar : every_scalar) {
        const Plots plots =
            plots_in(lettered_triangles({{'1', {"14.5", "12.5", "28.5", "12.5", "21.5", "24.5"}},
                                         {'2', {"14.5", "12.5", "21.5", "24.5", "7.5", "24.5"}},
                                         {'3', {"14.5", "12.5", "7.5", "24.5", "0.5", "12.5"}},
                                         {'4', {"14.5", "12.5", "0.5", "12.5", "7.5", "0.5"}},
                                         {'5', {"14.5", "12.5", "7.5", "0.5", "21.5", "0.5"}},
                                         {'6', {"14.5", "12.5", "21.5", "0.5", "28.5", "12.5"}}},
                                        canvas, {.scalar = scalar, .fill = Fill::top_left}));
        EXPECT_EQ(plots.owners, picture);
        EXPECT_EQ(std::count(plots.counts.begin(), plots.counts.end(), '1'), 504) << "once each:\n"
                                                                                  << plots.counts;
    }
}

TEST(TopLeft, TopIsTheTopOfThePicture) {
    // Microsoft's example: rectangle (0,0)-(5,5), centers on integers, split on the diagonal: 15
    // and 10. Its top row and left column are drawn, in either direction of y.
    const auto drawn = [](const std::vector<std::string>& coordinates, Origin origin) {
        return picture_of(draw_as_planned(triangle_scene(
            coordinates, {.width = 6, .height = 6, .origin = origin},
            {.scalar = ScalarKind::exact, .fill = Fill::top_left, .sample = Sample::integer})));
    };
    const std::string upper_left = "#####.\n####..\n###...\n##....\n#.....\n......\n";
    EXPECT_EQ(drawn({"0", "0", "5", "0", "0", "5"}, Origin::top_left), upper_left);
    EXPECT_EQ(drawn({"0", "5", "5", "5", "0", "0"}, Origin::bottom_left), upper_left);
}

// ---- Properties ---------------------------------------------------------------------------------

std::string twelfths(int value) {
    return std::to_string(value) + "/12";
}

RC_GTEST_PROP(Fills, VertexOrderMakesNoDifference, ()) {
    const Method method{.scalar = *rc::gen::element(ScalarKind::double_precision, ScalarKind::fixed,
                                                    ScalarKind::exact),
                        .fill = *rc::gen::element(Fill::two_halves, Fill::top_left),
                        .sample = *rc::gen::element(Sample::integer, Sample::center)};
    Scene scene = triangle_scene(any_triangle(130, 12), {.width = 20, .height = 20}, method);
    log_scene(scene);
    const std::string picture = picture_of(draw_as_planned(scene));
    auto& order = scene.primitives[0].vertices;
    while (std::next_permutation(order.begin(), order.end()))
        RC_ASSERT(picture_of(draw_as_planned(scene)) == picture);
}

RC_GTEST_PROP(Fills, TwoHalvesAreTheScanlineFillWhenExact, ()) {
    Method method{.scalar = *rc::gen::element(ScalarKind::fixed, ScalarKind::exact),
                  .rounding = *rc::gen::element(Rounding::floor, Rounding::nearest,
                                                Rounding::truncate, Rounding::inside),
                  .ties = *rc::gen::element(Ties::start, Ties::up, Ties::away, Ties::even),
                  .lerp = *rc::gen::element(LerpForm::direct, LerpForm::incremental)};
    Scene scene = triangle_scene(any_triangle(130, 12), {.width = 20, .height = 20}, method);
    log_scene(scene);
    const std::string picture = picture_of(draw_as_planned(scene));
    scene.method.fill = Fill::two_halves;
    RC_ASSERT(picture_of(draw_as_planned(scene)) == picture);
}

/// The edge function of a and b at a point, straight from its definition.
mpq_class edge_function(const SceneVertex& a, const SceneVertex& b, const mpq_class& x,
                        const mpq_class& y) {
    return (b.x.exact() - a.x.exact()) * (y - a.y.exact()) -
           (b.y.exact() - a.y.exact()) * (x - a.x.exact());
}

/// Where a point lies: the signs of its three edge functions.
struct Signs {
    bool inside;  ///< strictly
    bool on_edge; ///< on the boundary
};
Signs signs_at(const Scene& scene, const mpq_class& x, const mpq_class& y) {
    int positive = 0, negative = 0, zero = 0;
    for (std::size_t i = 0; i < 3; ++i) {
        const mpq_class e = edge_function(scene.vertices[i], scene.vertices[(i + 1) % 3], x, y);
        (sgn(e) > 0 ? positive : sgn(e) < 0 ? negative : zero) += 1;
    }
    return {positive == 3 || negative == 3, zero > 0 && (positive == 0 || negative == 0)};
}

RC_GTEST_PROP(Fills, CoverTheClosedOrTheOpenTriangle, ()) {
    Method method{.scalar = ScalarKind::exact,
                  .fill = *rc::gen::element(Fill::barycentric, Fill::top_left),
                  .sample = *rc::gen::element(Sample::integer, Sample::center)};
    const Scene scene = triangle_scene(any_triangle(130, 12), {.width = 20, .height = 20}, method);
    log_scene(scene);
    const SceneVertex& third = scene.vertices[2];
    RC_PRE(edge_function(scene.vertices[0], scene.vertices[1], third.x.exact(), third.y.exact()) !=
           0); // without area there is no inside
    const mpq_class offset = method.sample == Sample::center ? mpq_class(1, 2) : mpq_class(0);
    const Image image = draw_as_planned(scene);
    for (int row = 0; row < 20; ++row)
        for (int x = scene.canvas.left(); x <= scene.canvas.right(); ++x) {
            const int y = scene.canvas.y_of(row);
            const Signs signs = signs_at(scene, x + offset, y + offset);
            const bool is_drawn = image.at({x, y}) != no_color;
            if (!signs.on_edge)
                RC_ASSERT(is_drawn == signs.inside);
            else if (method.fill == Fill::barycentric)
                RC_ASSERT(is_drawn);
        }
}

RC_GTEST_PROP(TopLeft, EachSampleOfAMeshHasExactlyOneOwner, ()) {
    // A grid of 4 x 4 vertices, the inner ones moved about, each cell split on one of its
    // diagonals: the union is a square whose samples must all be drawn once, by every scalar.
    constexpr int side = 4;
    const auto scalar =
        *rc::gen::element(ScalarKind::double_precision, ScalarKind::fixed, ScalarKind::exact);
    const auto origin = *rc::gen::element(Origin::center, Origin::top_left, Origin::bottom_left);
    Scene scene;
    scene.canvas = {.width = 40, .height = 40, .origin = origin};
    scene.method = {.scalar = scalar,
                    .fill = Fill::top_left,
                    .sample = *rc::gen::element(Sample::integer, Sample::center)};
    const int start = origin == Origin::center ? -15 : 3;
    for (int row = 0; row < side; ++row)
        for (int column = 0; column < side; ++column) {
            const bool is_inner = row > 0 && row < side - 1 && column > 0 && column < side - 1;
            const auto moved = [is_inner] { return is_inner ? *rc::gen::inRange(-24, 25) : 0; };
            const int x = moved(), y = moved();
            scene.vertices.push_back({"", number(twelfths(12 * (start + 9 * column) + x)),
                                      number(twelfths(12 * (start + 9 * row) + y))});
        }
    for (std::size_t row = 0; row + 1 < side; ++row)
        for (std::size_t column = 0; column + 1 < side; ++column) {
            const std::size_t a = row * side + column, b = a + 1, c = a + side, d = c + 1;
            const auto add = [&scene](std::size_t p, std::size_t q, std::size_t r) {
                scene.primitives.push_back(
                    {.kind = PrimitiveKind::triangle, .name = {}, .vertices = {p, q, r}});
            };
            if (*rc::gen::arbitrary<bool>()) {
                add(a, b, c);
                add(d, c, b);
            } else {
                add(a, b, d);
                add(a, d, c);
            }
        }
    log_scene(scene);
    Counter counter;
    const Image image = draw_as_planned(scene, counter);
    RC_ASSERT(image.drawn() == 27u * 27u);
    RC_ASSERT(counter.pixels == 27u * 27u);
}

TEST(TopLeft, NoGapAtTheRightEdgeOfTheCanvas) {
    // The shared edge PM passes the sample of (9, 5) by less than doubles tell; M lies right of it.
    const Canvas canvas{.width = 10, .height = 10, .origin = Origin::top_left};
    const SampleGrid<double> grid({0.5, 0.5}, canvas);
    const Vec<double, 2> p{1000, -1000}, m{9.500000000000002, 5.500000000000001};
    Image image(canvas);
    for (const Vec<double, 2>& other : {Vec<double, 2>{-1000, 5.4}, Vec<double, 2>{1000, 5.6}})
        fill_top_left(Triangle<double>{{p, m, other}}, grid, canvas, FlatPainter(image, Color{}));
    EXPECT_NE(image.at({9, 5}), no_color);
}

/// How often each pixel of a canvas is plotted.
template <typename Real>
void count_pixels(const Triangle<Real>& triangle, const SampleGrid<Real>& grid,
                  const Canvas& canvas, std::vector<int>& counts) {
    Image image(canvas);
    fill_top_left(triangle, grid, canvas, FlatPainter(image, Color{}, [&](const auto& step) {
                      if constexpr (std::same_as<std::decay_t<decltype(step)>, PixelPlotted<>>)
                          ++counts[canvas.offset_of(step.pixel())];
                  }));
}

/// The edge from `p` to `q` and a vertex on either side of it: where both triangles together are all
/// there is, but for a margin, each sample has one owner; nowhere has one two.
template <typename Real>
void expect_one_owner(const std::array<Vec<Real, 2>, 4>& corners, Real margin,
                      const Canvas& canvas) {
    const auto& [p, q, r, s] = corners;
    const SampleGrid<Real> grid({Real(0.5), Real(0.5)}, canvas);
    std::vector<int> counts(static_cast<std::size_t>(canvas.width * canvas.height));
    count_pixels(Triangle<Real>{{p, q, r}}, grid, canvas, counts);
    count_pixels(Triangle<Real>{{s, q, p}}, grid, canvas, counts);

    // The four other sides, in long numbers.
    const std::array<std::array<Vec<Real, 2>, 2>, 4> sides{{{p, r}, {r, q}, {q, s}, {s, p}}};
    for (int row = 0; row < canvas.height; ++row)
        for (int x = canvas.left(); x <= canvas.right(); ++x) {
            const Pixel pixel{x, canvas.y_of(row)};
            const int count = counts[canvas.offset_of(pixel)];
            RC_ASSERT(count <= 1);
            int inside = 0;
            int outside = 0;
            for (const auto& [a, b] : sides) {
                const long double dx =
                    static_cast<long double>(b.x) - static_cast<long double>(a.x);
                const long double dy =
                    static_cast<long double>(b.y) - static_cast<long double>(a.y);
                const long double side = (dx * (pixel.y + 0.5L - static_cast<long double>(a.y)) -
                                          dy * (x + 0.5L - static_cast<long double>(a.x))) /
                                         std::hypot(dx, dy);
                inside += side > static_cast<long double>(margin) ? 1 : 0;
                outside += side < -static_cast<long double>(margin) ? 1 : 0;
            }
            if (inside == 4 || outside == 4)
                RC_ASSERT(count == 1);
        }
}

/// Corners that are rounded, near the canvas and as far away as 1e15.
template <typename Real> void expect_one_owner_of_any_edge() {
    const Canvas canvas{.width = 12,
                        .height = 12,
                        .origin = *rc::gen::element(Origin::top_left, Origin::bottom_left)};
    const Real scale = *rc::gen::element<Real>(Real(1), Real(1), Real(1e3), Real(1e6), Real(1e15));
    const auto any = [](int low, int high) {
        return static_cast<Real>(*rc::gen::inRange(low * 1000, high * 1000 + 1)) / 1000;
    };
    // The edge passes through a point of the canvas; the others stand off it.
    const Vec<Real, 2> at{any(0, 12), any(0, 12)};
    const Vec<Real, 2> way{any(-6, 6), any(-6, 6)};
    RC_PRE(way.x != 0 || way.y != 0);
    const Real off = any(1, 4);
    const auto far = [&](Real along, Real across) {
        return Vec<Real, 2>{at.x + scale * (along * way.x - across * way.y),
                            at.y + scale * (along * way.y + across * way.x)};
    };
    const std::array<Vec<Real, 2>, 4> corners{far(-1, 0), far(1, 0), far(any(-1, 1) / 2, off),
                                              far(any(-1, 1) / 2, -off)};
    expect_one_owner<Real>(corners, 64 * scale * std::numeric_limits<Real>::epsilon() * 12, canvas);
}

RC_GTEST_PROP(TopLeft, NoGapAndNoPixelTwiceAlongASharedEdgeOfDoubles, ()) {
    expect_one_owner_of_any_edge<double>();
}
RC_GTEST_PROP(TopLeft, NoGapAndNoPixelTwiceAlongASharedEdgeOfFloats, ()) {
    expect_one_owner_of_any_edge<float>();
}

RC_GTEST_PROP(Fills, NeverLetAFractionOverflow, ()) {
    // As for the scanline fill: the sanitizer watches, the rationals know the picture.
    const int bits = *rc::gen::inRange(1, 62);
    const std::int64_t largest = std::int64_t{1} << bits;
    const auto denominator = *rc::gen::inRange<std::int64_t>(1, 300);
    Scene scene;
    scene.canvas = {.width = 16, .height = 16};
    scene.method = {.scalar = ScalarKind::exact,
                    .line = *rc::gen::element(LineMethod::naive, LineMethod::dda),
                    .fill = *rc::gen::element(Fill::two_halves, Fill::barycentric, Fill::top_left),
                    .sample = *rc::gen::element(Sample::integer, Sample::center),
                    .lerp = *rc::gen::element(LerpForm::direct, LerpForm::incremental)};
    for (int i = 0; i < 3; ++i) {
        const auto coordinate = [&] {
            return number(std::to_string(*rc::gen::inRange<std::int64_t>(-largest, largest)) + "/" +
                          std::to_string(denominator));
        };
        const Number x = coordinate(), y = coordinate();
        scene.vertices.push_back({std::string(1, static_cast<char>('A' + i)), x, y,
                                  Color{static_cast<std::uint8_t>(255 - 100 * i), 0, 255}});
    }
    scene.primitives = {{.kind = *rc::gen::element(PrimitiveKind::triangle, PrimitiveKind::outline),
                         .name = "ABC",
                         .vertices = {0, 1, 2}}};
    log_scene(scene);
    RC_TAG(static_cast<int>(plan_for(scene).number));
    RC_ASSERT(draw_as_planned(scene).colors() == draw_with(NumberType::rational, scene).colors());
}

// ---- Colors -------------------------------------------------------------------------------------

TEST(MixedColors, AreThoseOfTheVerticesAtTheVertices) {
    for (const Fill fill : {Fill::scanline, Fill::two_halves, Fill::barycentric, Fill::fan})
        for (const ScalarKind scalar : every_scalar) {
            Scene scene = first_triangle({.scalar = scalar, .fill = fill});
            scene.vertices[0].color = Color{255, 0, 0};
            scene.vertices[1].color = Color{0, 255, 0};
            scene.vertices[2].color = Color{0, 0, 255};
            const Image image = draw_as_planned(scene);
            EXPECT_EQ(image.at({2, 5}), (Color{255, 0, 0}));
            EXPECT_EQ(image.at({-4, -3}), (Color{0, 255, 0}));
            EXPECT_EQ(image.at({5, -3}), (Color{0, 0, 255}));
        }
}

TEST(MixedColors, AreTheWeightsTimesTheColors) {
    // At (0, 0): 27/72, 31/72, 14/72 of 255: 95.625, 109.79, 49.58. On AB: half and half.
    Scene scene = first_triangle({.scalar = ScalarKind::exact, .fill = Fill::barycentric});
    scene.vertices[0].color = Color{255, 0, 0};
    scene.vertices[1].color = Color{0, 255, 0};
    scene.vertices[2].color = Color{0, 0, 255};
    const Image image = draw_as_planned(scene);
    EXPECT_EQ(image.at({0, 0}), (Color{96, 110, 50}));
    EXPECT_EQ(image.at({-1, 1}), (Color{128, 128, 0})) << "127.5 goes up";
}

TEST(MixedColors, OnlyWhenAskedFor) {
    Scene scene = first_triangle();
    EXPECT_FALSE(scene.mixes_colors());
    scene.vertices[0].color = Color{255, 0, 0};
    EXPECT_TRUE(scene.mixes_colors());
    scene.method.shade = Shade::flat;
    EXPECT_FALSE(scene.mixes_colors());
}

} // namespace
} // namespace rastertrace
