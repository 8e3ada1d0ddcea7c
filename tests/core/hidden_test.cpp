// SPDX-License-Identifier: MIT
// Hidden surfaces and light: T0's and T1's numbers, numerics.md part Z, and an exact reference.

#include "picture.h"
#include "random_choice.h"
#include "random_triangle.h"

#include <rastertrace/core/draw/list/light.h>
#include <rastertrace/core/raster/depth_interpolation.h>
#include <rastertrace/core/raster/shading.h>
#include <rastertrace/core/raster/triangle.h>

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

namespace rastertrace {
namespace {

/// A triangle of a scene: three places and a color.
struct Face3 {
    std::string name;
    std::array<std::array<Number, 3>, 3> corners;
    Color color;
};

const Color red{255, 0, 0};
const Color green{0, 255, 0};
const Color blue{0, 0, 255};

/// Triangles in the coordinates of the screen, with z as the distance from the eye.
Scene scene_of(const std::vector<Face3>& faces, Method method, int side = 64) {
    Scene scene;
    scene.canvas = {.width = side, .height = side, .origin = Origin::top_left};
    scene.method = method;
    for (const Face3& face : faces) {
        ScenePrimitive primitive{.kind = PrimitiveKind::triangle,
                                 .name = face.name,
                                 .vertices = {},
                                 .color = face.color};
        for (std::size_t i = 0; i < 3; ++i) {
            primitive.vertices[i] = scene.vertices.size();
            scene.vertices.push_back({face.name + std::to_string(i),
                                      face.corners[i][0],
                                      face.corners[i][1],
                                      {},
                                      face.corners[i][2]});
        }
        scene.primitives.push_back(primitive);
    }
    return scene;
}

/// The methods whose depths are right.
Method exact_method(Depth depth, Fill fill = Fill::top_left) {
    return {.scalar = ScalarKind::exact, .fill = fill, .depth = depth};
}

/// Depths of rows, and those of their pixels.
struct RowSink {
    std::vector<ScanlineSpanned<Rational>> rows;
    std::vector<std::pair<Pixel, Rational>> depths;
    void operator()(const ScanlineSpanned<>& step) {
        ScanlineSpanned<Rational> row{};
        row.y = step.y;
        row.from = step.from;
        row.to = step.to;
        row.left_depth = step.left_depth->exact();
        row.right_depth = step.right_depth->exact();
        rows.push_back(row);
    }
    void operator()(const DepthTested<>& step) {
        depths.emplace_back(step.pixel(), step.depth.exact());
    }
};

TEST(DepthAt, RoundedEndsHaveTheDepthsOfTheEdges) {
    // CGFS interpolates between the pixels that the ends are rounded to. Where it is wrong, it is wrong
    // by less than a pixel's change of depth.
    for (const Fill fill : {Fill::scanline, Fill::two_halves})
        for (const Rounding rounding : {Rounding::floor, Rounding::nearest, Rounding::truncate,
                                        Rounding::inside, Rounding::half_open}) {
            Method method = exact_method(Depth::linear_z, fill);
            method.rounding = rounding;
            method.depth_at = DepthAt::rounded_ends;
            const Face3 face{"a",
                             {{{number("25/3"), number("7/2"), number("2")},
                               {number("151/4"), number("31/3"), number("9")},
                               {number("55/4"), number("40"), number("5")}}},
                             red};
            Face3 behind = face;
            behind.name = "b";
            RowSink sink;
            draw_as_planned(scene_of({face, behind}, method), sink);
            ASSERT_FALSE(sink.depths.empty());
            std::size_t next = 0;
            for (const auto& row : sink.rows)
                for (Index x = row.from; x <= row.to; ++x, ++next) {
                    const auto& [pixel, depth] = sink.depths.at(next);
                    ASSERT_EQ(pixel, (Pixel{static_cast<int>(x), row.y}));
                    const Rational part =
                        row.from == row.to
                            ? Rational(0)
                            : Rational(Rational(x - row.from) / Rational(row.to - row.from));
                    ASSERT_EQ(depth, Rational(*row.left_depth +
                                              part * (*row.right_depth - *row.left_depth)));
                }
            EXPECT_EQ(next, sink.depths.size());
        }
}

TEST(DepthAt, RoundedEndsAreDecidedAlikeByAdaptiveAndExact) {
    Random random(8);
    for (int i = 0; i < 200; ++i) {
        const auto any = [&random] { return Number::fraction(Rational(random.whole(0, 320), 5)); };
        const auto face = [&](const std::string& name, Color color) {
            Face3 result{name, {}, color};
            for (auto& corner : result.corners)
                corner = {any(), any(), Number(random.whole(1, 6))};
            return result;
        };
        const std::vector<Face3> faces{face("a", red), face("b", green), face("c", blue)};
        Method method = exact_method(random.pick({Depth::linear_z, Depth::inverse_z}),
                                     random.pick({Fill::scanline, Fill::two_halves}));
        method.depth_at = DepthAt::rounded_ends;
        const Scene exact = scene_of(faces, method);
        method.scalar = ScalarKind::adaptive;
        ASSERT_EQ(draw_as_planned(scene_of(faces, method)).colors(),
                  draw_as_planned(exact).colors());
    }
}

// Culling.

struct FaceSink {
    std::map<std::string, FaceTested<Rational>> faces;
    std::string current;
    void operator()(const PrimitiveBegan<>& step) { current = step.name; }
    void operator()(const FaceTested<>& step) {
        faces.emplace(current, FaceTested<Rational>{.normal = as<Rational>(step.normal),
                                                    .view = as<Rational>(step.view),
                                                    .dot = step.dot.exact(),
                                                    .cosine = step.cosine,
                                                    .culled = step.culled,
                                                    .opposite = step.opposite});
    }
};

TEST(Culling, TableOfT0sCube) {
    const Scene scene = cube_of_t0(
        {"ABC", "ACD", "EHG", "EGF", "ADE", "DHE", "BFG", "BGC", "AEF", "AFB", "DCG", "DGH"});
    FaceSink sink;
    draw_as_planned(scene, sink);
    ASSERT_EQ(sink.faces.size(), 12u);
    std::size_t drawn = 0;
    for (const auto& [name, face] : sink.faces) {
        drawn += face.culled ? 0 : 1;
        EXPECT_NE(face.culled, face.opposite) << name;
        const bool is_front = name == "ABC" || name == "ACD";
        const bool is_back = name == "EHG" || name == "EGF";
        EXPECT_EQ(face.dot, is_front ? 12 : is_back ? -20 : -4) << name;
        if (!is_front && !is_back) {
            EXPECT_TRUE(std::abs(*face.cosine + 0.2621) < 5e-5 ||
                        std::abs(*face.cosine + 0.2242) < 5e-5)
                << name;
        }
    }
    EXPECT_EQ(drawn, 2u);
    // The front, from -10/3 to 10/3: of its two halves the first one named keeps the diagonal.
    EXPECT_EQ(plots_in(cube_of_t0({"ABC", "CDA", "EHG", "EGF"})).owners, "..........\n"
                                                                         "..........\n"
                                                                         ".CAAAAAAA.\n"
                                                                         ".CCAAAAAA.\n"
                                                                         ".CCCAAAAA.\n"
                                                                         ".CCCCAAAA.\n"
                                                                         ".CCCCCAAA.\n"
                                                                         ".CCCCCCAA.\n"
                                                                         ".CCCCCCCA.\n"
                                                                         "..........\n");
    const auto& front = sink.faces.at("ABC");
    EXPECT_EQ(std::tuple(front.normal.x, front.normal.y, front.normal.z),
              std::tuple(Rational(0), Rational(0), Rational(-4)));
    EXPECT_EQ(std::tuple(front.view.x, front.view.y, front.view.z),
              std::tuple(Rational("-1/3"), Rational("-1/3"), Rational(-3)))
        << "from the centroid (1/3, 1/3, 3) to the eye";
    EXPECT_NEAR(*front.cosine, 0.9879, 5e-5);
    EXPECT_NEAR(std::acos(-*front.cosine) * 180 / std::acos(-1.0), 171.07, 0.005)
        << "between the normal and the text's vector, from the eye";
    EXPECT_NEAR(*sink.faces.at("EHG").cosine, -0.9956, 5e-5);
}

TEST(Culling, TheTextsAedIsWoundInwardAndSurvives) {
    FaceSink sink;
    draw_as_planned(cube_of_t0({"AED", "ADE"}), sink);
    EXPECT_EQ(sink.faces.at("AED").dot, 4);
    EXPECT_FALSE(sink.faces.at("AED").culled);
    EXPECT_EQ(sink.faces.at("ADE").dot, -4);
    EXPECT_TRUE(sink.faces.at("ADE").culled);
}

TEST(Culling, EveryChoiceAndTheEdgeOnFace) {
    EXPECT_FALSE(is_culled(Cull::back, 1.0));
    EXPECT_TRUE(is_culled(Cull::back, 0.0)) << "T1: 0 < cos, so 0 is culled";
    EXPECT_TRUE(is_culled(Cull::back, -1.0));
    EXPECT_TRUE(is_culled(Cull::front, 1.0));
    EXPECT_TRUE(is_culled(Cull::front, 0.0));
    EXPECT_FALSE(is_culled(Cull::front, -1.0));
    EXPECT_TRUE(is_culled(Cull::both, 1.0) && is_culled(Cull::both, -1.0));
    EXPECT_FALSE(is_culled(Cull::none, -1.0));
}

TEST(Culling, CosinesOfT1) {
    using V = Vec<Rational, 3>;
    const V n{Rational(0), Rational(0), Rational(1)};
    const auto cosine = [&n](int x, int z) {
        return *cosine_between(n, V{Rational(x), Rational(0), Rational(z)});
    };
    EXPECT_EQ(cosine(1, 1), std::sqrt(0.5));
    EXPECT_EQ(cosine(1, 0), 0);
    EXPECT_EQ(cosine(1, -1), -std::sqrt(0.5));
    EXPECT_NEAR(*cosine_between(Vec<double, 3>(0, 0, 1e200), Vec<double, 3>(1e-200, 0, 1e-200)),
                std::sqrt(0.5), 1e-15);
    EXPECT_FALSE(cosine_between(Vec<double, 3>(0, 0, 0), Vec<double, 3>(1, 0, 0)));
}

// P4, P7: edge-on, and an eye on the face's plane or in its centroid: 0, culled, and no NaN.
TEST(Culling, AnEyeOnTheFacesPlaneSeesNothing) {
    for (const Numbers3& eye :
         {Numbers3{5, 0, -3}, Numbers3{Number(1), 0, Number(-1)},
          Numbers3{Number::fraction(mpq_class("1/3")), 0, Number::fraction(mpq_class("-1/3"))}}) {
        Scene scene = scene_of({{"f", {{{0, 0, 0}, {1, 0, 0}, {0, 0, -1}}}, red}},
                               {.scalar = ScalarKind::exact, .cull = Cull::back});
        scene.camera = Camera{.position = eye, .look_at = {eye[0], 0, -100}, .up = {0, 1, 0}};
        scene.projection = {.type = ProjectionType::pinhole, .distance = 1};
        scene.viewport = {.type = ViewportType::pixels, .pixels_per_unit = 1};
        FaceSink sink;
        EXPECT_EQ(draw_as_planned(scene, sink).drawn(), 0u);
        EXPECT_EQ(sink.faces.at("f").dot, 0);
        EXPECT_TRUE(sink.faces.at("f").culled);
    }
}

// Light.

struct LightSink {
    std::vector<double> intensities;
    void operator()(const FaceLit<>& step) { intensities.push_back(step.intensity); }
};

TEST(Light, IsTheCosineAndNeverNegative) {
    // The face looks along +z; the light comes at 60 degrees, along it, and from behind.
    const auto intensity = [](Numbers3 direction) {
        Scene scene = scene_of({{"f", {{{0, 0, 0}, {9, 0, 0}, {0, 9, 0}}}, {200, 100, 50}}},
                               {.scalar = ScalarKind::exact, .shade = Shade::lambert});
        scene.light = Light{.kind = Light::Kind::direction, .at = direction};
        LightSink sink;
        const Image image = draw_as_planned(scene, sink);
        return std::pair(sink.intensities.at(0), image.at({1, 1}));
    };
    EXPECT_EQ(intensity({0, 0, 3}), std::pair(1.0, Color(200, 100, 50)));
    EXPECT_EQ(intensity({4, 0, 3}), std::pair(0.6, Color(120, 60, 30)));
    EXPECT_EQ(intensity({1, 0, 0}), std::pair(0.0, Color(0, 0, 0)));
    EXPECT_EQ(intensity({0, 0, -3}), std::pair(0.0, Color(0, 0, 0)));
}

// Depths.

/// The depth of the last test at each pixel.
template <typename D> struct DepthSink {
    std::map<std::pair<int, int>, D> depths;
    std::size_t tests = 0;
    std::size_t passes = 0;
    void operator()(const DepthTested<>& step) {
        depths[{step.x, step.y}] = as<D>(step.depth);
        ++tests;
        passes += step.pass ? 1 : 0;
    }
};

/// The depths at the right ends of the rows of T0's triangle AED, D (-3, -3) to E (-2, 2), from the
/// top row.
struct EndDepths {
    std::vector<Rational> right;
    void operator()(const ScanlineSpanned<>& step) {
        if (step.y <= 2)
            right.push_back(step.right_depth.value().exact());
    }
};

TEST(Depth, TableOfT0sEdge) {
    const auto depths = [](Depth depth, int z_of_e) {
        Scene scene = scene_of({{"AED", {{{-3, 3, 3}, {-2, 2, z_of_e}, {-3, -3, 3}}}, red}},
                               {.scalar = ScalarKind::exact, .depth = depth});
        scene.canvas = {.width = 10, .height = 10};
        scene.keep.add(Stage::depth); // one triangle needs no buffer
        EndDepths sink;
        draw_as_planned(scene, sink);
        sink.right.resize(6);
        return sink.right;
    };
    const auto q = [](const char* text) { return Rational(text); };
    EXPECT_EQ(depths(Depth::linear_z, 4),
              (std::vector{q("4"), q("19/5"), q("18/5"), q("17/5"), q("16/5"), q("3")}));
    EXPECT_EQ(depths(Depth::inverse_z, 4),
              (std::vector{q("1/4"), q("4/15"), q("17/60"), q("3/10"), q("19/60"), q("1/3")}));
    EXPECT_EQ(depths(Depth::inverse_z, 5),
              (std::vector{q("1/5"), q("17/75"), q("19/75"), q("7/25"), q("23/75"), q("1/3")}));
    // The largest error of z, at y = 0.
    EXPECT_EQ(depths(Depth::linear_z, 4)[2] - 1 / depths(Depth::inverse_z, 4)[2], q("6/85"));
    EXPECT_EQ(depths(Depth::linear_z, 5)[2] - 1 / depths(Depth::inverse_z, 5)[2], q("24/95"));
}

// CGFS: between z = 2 and z = 10, the point whose true z is 6 lies 5/6 of the way along; z
// interpolated is 26/3 there.
TEST(Depth, MidpointOfCgfs) {
    const Triangle<Rational> triangle{
        {{{Rational(0), Rational(0)}, {Rational(6), Rational(6)}, {Rational(0), Rational(6)}}}};
    TriangleDepth<Rational> linear(triangle.vertices, {2, 10, 10}, false);
    TriangleDepth<Rational> inverse(triangle.vertices,
                                    {Rational("1/2"), Rational("1/10"), Rational("1/10")}, false);
    EXPECT_EQ(linear.on_edge({0, 1}, 5), Rational("26/3"));
    EXPECT_EQ(Rational(1 / inverse.on_edge({0, 1}, 5)), 6);
}

TEST(Depth, SteepTriangleOfZ2) {
    // 1, from z = 1 to z = 9, and 2 at z = 4 all over, meet at 3/4 of 9/8 of the side, or by linear z at
    // 3/8 of it.
    const auto scene = [](int side, ScalarKind scalar, Depth depth) {
        return scene_of({{"1", {{{0, 0, 1}, {side, 0, 9}, {0, side, 1}}}, red},
                         {"2", {{{0, 0, 4}, {side, 0, 4}, {0, side, 4}}}, blue}},
                        {.scalar = scalar, .fill = Fill::top_left, .depth = depth}, side);
    };
    for (const ScalarKind scalar : {ScalarKind::exact, ScalarKind::double_precision,
                                    ScalarKind::fixed, ScalarKind::single_precision}) {
        EXPECT_EQ(side_by_side({plots_in(scene(18, scalar, Depth::inverse_z)).owners,
                                plots_in(scene(18, scalar, Depth::linear_z)).owners}),
                  "11111111111111122.  11111112222222222.\n"
                  "1111111111111112..  1111111222222222..\n"
                  "111111111111111...  111111122222222...\n"
                  "11111111111111....  11111112222222....\n"
                  "1111111111111.....  1111111222222.....\n"
                  "111111111111......  111111122222......\n"
                  "11111111111.......  11111112222.......\n"
                  "1111111111........  1111111222........\n"
                  "111111111.........  111111122.........\n"
                  "11111111..........  11111112..........\n"
                  "1111111...........  1111111...........\n"
                  "111111............  111111............\n"
                  "11111.............  11111.............\n"
                  "1111..............  1111..............\n"
                  "111...............  111...............\n"
                  "11................  11................\n"
                  "1.................  1.................\n"
                  "..................  ..................\n");
        const Image right = draw_as_planned(scene(64, scalar, Depth::inverse_z));
        EXPECT_EQ(right.drawn(), 2016u);
        EXPECT_EQ(count_of(right, red), 1971u);
        EXPECT_EQ(count_of(draw_as_planned(scene(64, scalar, Depth::linear_z)), red), 1236u);
    }
}

TEST(Depth, EqualLayersOfZ7KeepTheFirst) {
    std::vector<Face3> faces{{"first", {{{0, 0, 5}, {8, 0, 5}, {0, 8, 5}}}, red}};
    for (int i = 1; i < 100; ++i)
        faces.push_back({"later" + std::to_string(i), faces.front().corners, blue});
    std::vector<std::string> owners;
    for (const Fill fill : {Fill::top_left, Fill::barycentric, Fill::scanline, Fill::two_halves}) {
        const Scene scene = scene_of(faces, {.fill = fill, .depth = Depth::inverse_z}, 10);
        owners.push_back(plots_in(scene).owners);
        DepthSink<double> sink;
        const Image image = draw_as_planned(scene, sink);
        EXPECT_EQ(sink.passes, image.drawn());
        EXPECT_EQ(sink.tests, 100 * image.drawn());
    }
    // 28 pixels by the top-left rule, 45 with all edges.
    EXPECT_EQ(side_by_side(owners), "fffffff...  fffffffff.  fffffffff.  fffffffff.\n"
                                    "ffffff....  ffffffff..  ffffffff..  ffffffff..\n"
                                    "fffff.....  fffffff...  fffffff...  fffffff...\n"
                                    "ffff......  ffffff....  ffffff....  ffffff....\n"
                                    "fff.......  fffff.....  fffff.....  fffff.....\n"
                                    "ff........  ffff......  ffff......  ffff......\n"
                                    "f.........  fff.......  fff.......  fff.......\n"
                                    "..........  ff........  ff........  ff........\n"
                                    "..........  f.........  f.........  f.........\n"
                                    "..........  ..........  ..........  ..........\n");
}

TEST(Depth, CrossingOnCentersOfZ9) {
    // Two planes that cross on a column of centers, which the first one drawn keeps.
    const Number half = Number::decimal(5, -1);
    const auto scene = [&half](const std::string& order, int side) {
        const Number end = Number::decimal(10 * side - 5, -1);
        std::vector<Face3> faces{{"1", {{{half, half, 1}, {end, half, 3}, {half, end, 1}}}, red},
                                 {"2", {{{half, half, 3}, {end, half, 1}, {half, end, 3}}}, blue}};
        if (order == "21")
            std::swap(faces[0], faces[1]);
        return scene_of(faces, exact_method(Depth::linear_z), side);
    };
    EXPECT_EQ(side_by_side({plots_in(scene("12", 9)).owners, plots_in(scene("21", 9)).owners}),
              "11111222.  11112222.\n"
              "1111122..  1111222..\n"
              "111112...  111122...\n"
              "11111....  11112....\n"
              "1111.....  1111.....\n"
              "111......  111......\n"
              "11.......  11.......\n"
              "1........  1........\n"
              ".........  .........\n");
    EXPECT_EQ(count_of(draw_as_planned(scene("12", 65)), red), 1584u) << "with the 32 ties";
    EXPECT_EQ(count_of(draw_as_planned(scene("21", 65)), red), 1552u);
}

TEST(Depth, NothingIsNearerThanTheFarEnd) {
    // Z12: a depth equal to what the buffer starts at is not drawn.
    Scene scene = scene_of({{"far", {{{-8, -8, -9}, {8, -8, -9}, {0, 8, -9}}}, red}},
                           exact_method(Depth::ndc_z), 16);
    scene.projection = {.type = ProjectionType::frustum, .near = Number(1), .far = Number(9)};
    scene.viewport = {.type = ViewportType::pixels, .pixels_per_unit = 1};
    DepthSink<Rational> sink;
    EXPECT_EQ(draw_as_planned(scene, sink).drawn(), 0u);
    EXPECT_GT(sink.tests, 0u);
    EXPECT_EQ(sink.passes, 0u);
}

TEST(Depth, ZeroOrLessIsRefusedForInverseZ) {
    for (const int z : {0, -3}) {
        const Scene scene = scene_of({{"T", {{{0, 0, 1}, {8, 0, z}, {0, 8, 1}}}, red}},
                                     exact_method(Depth::inverse_z));
        const auto unfit = find_unfit(scene);
        ASSERT_TRUE(unfit);
        EXPECT_EQ(unfit->what, Unfit::What::depth);
        EXPECT_EQ(unfit->to, 1u);
    }
}

// The painter.

TEST(Painter, CycleOfZ10HasNoRightOrder) {
    const auto faces = [](int part) {
        const auto at = [part](int x, int y, int z) {
            return std::array<Number, 3>{Number::fraction(Rational(x) / part),
                                         Number::fraction(Rational(y) / part), z};
        };
        return std::vector<Face3>{{"A", {{at(4, 28, 2), at(60, 24, 6), at(60, 34, 6)}}, red},
                                  {"B", {{at(28, 60, 2), at(26, 4, 6), at(36, 4, 6)}}, green},
                                  {"C", {{at(58, 6, 2), at(10, 60, 6), at(4, 52, 6)}}, blue}};
    };
    const Image right = draw_as_planned(scene_of(faces(1), exact_method(Depth::inverse_z)));
    EXPECT_EQ(right.drawn(), 817u);

    // A quarter of its size: the head of A lies on B, that of B on C, that of C on A; drawn as ABC, C
    // lies on both.
    const auto small = [&faces](Depth depth) {
        return plots_in(scene_of(faces(4), exact_method(depth), 16)).owners;
    };
    EXPECT_EQ(side_by_side({small(Depth::inverse_z), small(Depth::none)}),
              "................  ................\n"
              ".......BB.......  .......BB.......\n"
              ".......BB....C..  .......BB....C..\n"
              ".......BB...C...  .......BB...C...\n"
              ".......B...C....  .......B...C....\n"
              ".......B..C.....  .......B..C.....\n"
              ".......BACAAAAA.  .......BACAAAAA.\n"
              "......AACAAAAAA.  ......ACCAAAAAA.\n"
              "......CB........  ......CC........\n"
              ".....CCB........  .....CCB........\n"
              "....CC.B........  ....CC.B........\n"
              "...CCC..........  ...CCC..........\n"
              "..CCC...........  ..CCC...........\n"
              ".CCC............  .CCC............\n"
              "..C.............  ..C.............\n"
              "................  ................\n");

    std::array<std::size_t, 3> order{0, 1, 2};
    do {
        const std::vector<Face3> ordered{faces(1)[order[0]], faces(1)[order[1]],
                                         faces(1)[order[2]]};
        EXPECT_EQ(draw_as_planned(scene_of(ordered, exact_method(Depth::inverse_z))).colors(),
                  right.colors());
        EXPECT_NE(draw_as_planned(scene_of(ordered, exact_method(Depth::none))).colors(),
                  right.colors())
            << "drawn one after the other, in any order";
    } while (std::next_permutation(order.begin(), order.end()));
}

// A long floor, and a box on it or under it: which key is right depends on where the box stands.
TEST(Painter, NoKeyIsRightForZ11) {
    const auto wrong = [](int z, PainterKey key) {
        const std::vector<Face3> faces{{"floor", {{{0, 63, 2}, {63, 63, 2}, {32, 10, 100}}}, red},
                                       {"box", {{{28, 30, z}, {36, 30, z}, {32, 38, z}}}, blue}};
        Method method = exact_method(Depth::painter);
        method.painter_key = key;
        const Image painted = draw_as_planned(scene_of(faces, method));
        const Image right = draw_as_planned(scene_of(faces, exact_method(Depth::inverse_z)));
        std::size_t differing = 0;
        for (std::size_t i = 0; i < right.colors().size(); ++i)
            differing += right.colors()[i] == painted.colors()[i] ? 0 : 1;
        return differing;
    };
    EXPECT_EQ(wrong(3, PainterKey::nearest), 32u);
    EXPECT_EQ(wrong(3, PainterKey::mean), 0u);
    EXPECT_EQ(wrong(30, PainterKey::nearest), 0u);
    EXPECT_EQ(wrong(30, PainterKey::mean), 32u);
    EXPECT_EQ(wrong(30, PainterKey::farthest), 32u);
}

// Against an exact reference.

/// Random triangles in front of a pinhole, one above the other and through each other.
std::vector<Face3> random_faces(std::size_t count) {
    std::vector<Face3> faces;
    for (std::size_t i = 0; i < count; ++i) {
        Face3 face{{static_cast<char>('A' + i)}, {}, color_of_face(i)};
        for (auto& corner : face.corners) {
            const int z = *rc::gen::inRange(1, 12);
            corner = {*rc::gen::inRange(-8, 9) * z, *rc::gen::inRange(-8, 9) * z, z};
        }
        faces.push_back(face);
    }
    return faces;
}

/// Those faces seen by a pinhole on 17 x 17 pixels.
Scene seen_by_pinhole(const std::vector<Face3>& faces, Method method) {
    Scene scene = scene_of(faces, method);
    scene.canvas = {.width = 17, .height = 17};
    scene.projection = {.type = ProjectionType::pinhole, .distance = 1};
    scene.viewport = {.type = ViewportType::pixels_per_unit, .pixels_per_unit = 1};
    return scene;
}

/// The letter of the face that a ray through a pixel's integer point meets first, in closed
/// triangles; of equals the first. Worked out in space: no projection, no interpolation.
char nearest_along_ray(const std::vector<Face3>& faces, int x, int y) {
    using V = Vec<Rational, 3>;
    const V ray{Rational(x), Rational(y), Rational(1)};
    std::optional<Rational> nearest;
    char letter = '.';
    for (const Face3& face : faces) {
        const V a = exact(face.corners[0]);
        const V b = exact(face.corners[1]);
        const V c = exact(face.corners[2]);
        const V n = cross(b - a, c - a);
        const Rational slope = dot(n, ray);
        if (slope == 0)
            continue; // edge-on
        const Rational z = dot(n, a) / slope;
        const V p{Rational(x * z), Rational(y * z), z};
        const std::array sides{sgn(dot(cross(b - a, p - a), n)), sgn(dot(cross(c - b, p - b), n)),
                               sgn(dot(cross(a - c, p - c), n))};
        const bool is_inside = sides[0] >= 0 && sides[1] >= 0 && sides[2] >= 0;
        if (is_inside && (!nearest || z < *nearest)) {
            nearest = z;
            letter = face.name.front();
        }
    }
    return letter;
}

// Every pixel of every picture, for the depths that are linear on the screen.
RC_GTEST_PROP(Depth, FindsTheFaceThatARayMeetsFirst, ()) {
    const auto faces = random_faces(4);
    std::string by_rays;
    for (int y = 8; y >= -8; --y, by_rays += '\n')
        for (int x = -8; x <= 8; ++x)
            by_rays += nearest_along_ray(faces, x, y);
    for (const Depth depth : {Depth::inverse_z, Depth::ndc_z}) {
        const Scene scene = seen_by_pinhole(faces, exact_method(depth, Fill::barycentric));
        log_scene(scene);
        RC_ASSERT(plots_in(scene).owners == by_rays);
    }
}

// By rows and then across, and by weights: the same depths in exact arithmetic, wherever both draw.
RC_GTEST_PROP(Depth, RowsAndWeightsAgree, ()) {
    const auto faces = random_faces(1);
    const auto depths = [&faces](Fill fill) {
        Method method = exact_method(Depth::inverse_z, fill);
        method.rounding = Rounding::inside;
        method.sample = Sample::integer;
        DepthSink<Rational> sink;
        Scene scene = seen_by_pinhole(faces, method);
        scene.keep.add(Stage::depth);
        log_scene(scene);
        draw_as_planned(scene, sink);
        return sink.depths;
    };
    const auto by_weights = depths(Fill::barycentric);
    RC_PRE(!by_weights.empty()); // without area there are no weights
    for (const Fill fill : {Fill::scanline, Fill::two_halves, Fill::top_left})
        for (const auto& [pixel, depth] : depths(fill)) {
            RC_ASSERT(by_weights.contains(pixel)); // the closed triangle has them all
            RC_ASSERT(by_weights.at(pixel) == depth);
        }
}

struct TieSink {
    bool has_tie = false;
    void operator()(const DepthTested<>& step) {
        has_tie = has_tie || (step.stored && *step.stored == step.depth);
    }
};

// Where no depths tie, any order of the triangles gives one picture.
RC_GTEST_PROP(Depth, OrderDoesNotMatterWithoutTies, ()) {
    auto faces = random_faces(4);
    const Method method = exact_method(Depth::inverse_z);
    TieSink ties;
    const Scene scene = seen_by_pinhole(faces, method);
    log_scene(scene);
    const Image image = draw_as_planned(scene, ties);
    RC_PRE(!ties.has_tie);
    std::rotate(faces.begin(), faces.begin() + *rc::gen::inRange(1, 4), faces.end());
    std::swap(faces[0], faces[1]);
    RC_ASSERT(draw_as_planned(seen_by_pinhole(faces, method)).colors() == image.colors());
}

// What is documented to be wrong is wrong: in 200 scenes of long and steep triangles, both linear z
// and the painter show the wrong face somewhere.
TEST(Depth, LinearZAndThePainterAreSometimesWrong) {
    std::uint32_t state = 12345;
    const auto random = [&state](int low, int high) {
        state = state * 1664525 + 1013904223;
        return low + static_cast<int>(state >> 16) % (high - low + 1);
    };
    std::size_t pixels = 0;
    std::size_t wrong_linear = 0;
    std::size_t wrong_painter = 0;
    for (int i = 0; i < 200; ++i) {
        std::vector<Face3> faces;
        for (std::size_t k = 0; k < 3; ++k) {
            Face3 face{"T" + std::to_string(k), {}, color_of_face(k)};
            for (auto& corner : face.corners) {
                const int z = random(1, 20);
                corner = {random(-8, 8) * z, random(-8, 8) * z, z};
            }
            faces.push_back(face);
        }
        const auto colors = [&faces](Depth depth) {
            return draw_as_planned(seen_by_pinhole(faces, {.depth = depth})).colors();
        };
        const auto right = colors(Depth::inverse_z);
        const auto linear = colors(Depth::linear_z);
        const auto painted = colors(Depth::painter);
        for (std::size_t place = 0; place < right.size(); ++place) {
            pixels += right[place] == no_color ? 0 : 1;
            wrong_linear += linear[place] == right[place] ? 0 : 1;
            wrong_painter += painted[place] == right[place] ? 0 : 1;
        }
    }
    EXPECT_GT(wrong_linear, 0u);
    EXPECT_GT(wrong_painter, 0u);
    RecordProperty("pixels", static_cast<int>(pixels));
    std::printf("of %zu pixels, linear z shows %zu wrong and the painter %zu\n", pixels,
                wrong_linear, wrong_painter);
}

// Colors in a perspective: halfway across the screen between z = 1 and z = 3, a point lies a
// quarter of the way along in space.
TEST(Shade, MixesAsInSpaceOrAsOnTheScreen) {
    const auto middle = [](Shade shade) {
        Scene scene = seen_by_pinhole(
            {{"T", {{{-8, -8, 1}, {24, -24, 3}, {-8, 8, 1}}}, {}}},
            {.scalar = ScalarKind::exact, .fill = Fill::barycentric, .shade = shade});
        scene.vertices[0].color = Color{0, 0, 0};
        scene.vertices[1].color = Color{200, 0, 0};
        scene.vertices[2].color = Color{0, 0, 0};
        return draw_as_planned(scene).at({0, -8}).red();
    };
    EXPECT_EQ(middle(Shade::interpolate), 50);
    EXPECT_EQ(middle(Shade::affine), 100);
}

// The same for any triangle: the point of the plane that a ray through the pixel meets, weighed by
// Cramer's rule in space. No projection, no 1/w.
RC_GTEST_PROP(Shade, MixesWhatTheRayMeets, ()) {
    using V = Vec<Rational, 3>;
    const Face3 face = random_faces(1).front();
    Scene scene = seen_by_pinhole({face}, {.scalar = ScalarKind::exact, .fill = Fill::barycentric});
    std::array<int, 3> levels{};
    for (std::size_t i = 0; i < 3; ++i) {
        levels[i] = *rc::gen::inRange(0, 256);
        scene.vertices[i].color = Color{static_cast<std::uint8_t>(levels[i]), 0, 0};
    }
    log_scene(scene);
    const Image image = draw_as_planned(scene);

    const V a = exact(face.corners[0]);
    const V b = exact(face.corners[1]);
    const V c = exact(face.corners[2]);
    for (int y = -8; y <= 8; ++y)
        for (int x = -8; x <= 8; ++x) {
            const bool is_drawn = image.at({x, y}) != no_color;
            RC_ASSERT(is_drawn == (nearest_along_ray({face}, x, y) != '.'));
            if (!is_drawn)
                continue;
            const V ray{Rational(x), Rational(y), Rational(1)};
            const std::array<Rational, 3> shares{dot(ray, cross(b, c)), dot(ray, cross(c, a)),
                                                 dot(ray, cross(a, b))};
            const Rational sum = shares[0] + shares[1] + shares[2];
            const Rational level =
                (shares[0] * levels[0] + shares[1] * levels[1] + shares[2] * levels[2]) / sum;
            RC_ASSERT(image.at({x, y}).red() == floor_index(Rational(level + Rational(1, 2))));
        }
}

// 400 planes from z = 1000 to 1001, near 1/10, far 10000, in float (docs/pipeline.md): z/w is rounded next to 1 before a
// range of [1, 0] turns it.
TEST(DepthRange, ReversedIsNoFinerInFloatButAReversedMatrixIs) {
    const auto depths_of = [](Depth depth, bool has_range, bool is_reversed_before) {
        Scene scene;
        scene.canvas = {.width = 2, .height = 2};
        scene.projection = {.type = ProjectionType::frustum,
                            .fov_y = 90,
                            .near = Number::decimal(1, -1),
                            .far = 10000};
        scene.viewport = {.type = ViewportType::pixels, .pixels = PixelRange::edges};
        if (has_range)
            scene.viewport.depths = DepthRange<Number>{1, 0};
        scene.method = {.scalar = ScalarKind::single_precision, .depth = depth};
        scene.keep.add(Stage::depth);
        for (std::size_t i = 0; i < 400; ++i) {
            const Rational z = 1000 + Rational(static_cast<int>(i)) / 399;
            SceneVertex& vertex =
                scene.vertices.emplace_back(SceneVertex{.name = "P", .x = 0, .y = 0});
            vertex.z = Number::fraction(-z);
            if (is_reversed_before) { // w at the near plane, 0 at the far one
                scene.projection = {.type = ProjectionType::clip_space, .z_from_zero = true};
                vertex.z = Number::fraction((10000 - z) / Rational(99999));
                vertex.w = Number::fraction(z);
                scene.method.depth_compare = DepthCompare::greater;
            }
            scene.primitives.push_back(
                {.kind = PrimitiveKind::point, .name = "P", .vertices = {i}});
        }
        std::set<double> depths;
        draw(scene, plan_for(scene),
             [&depths](const DepthTested<>& test) { depths.insert(test.depth.to_double()); });
        return depths.size();
    };
    EXPECT_EQ(depths_of(Depth::ndc_z, true, false), 4U);
    EXPECT_EQ(depths_of(Depth::inverse_z, false, false), 400U);
    EXPECT_EQ(depths_of(Depth::ndc_z, false, true), 400U);
}

} // namespace
} // namespace rastertrace
