// SPDX-License-Identifier: MIT
// Vertices on edges that have no vertex there: which are told of, with which pixels, and what is none.

#include "picture.h"
#include "random_triangle.h"
#include "trace/stats_of_scene.h"

#include <fmt/core.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <rapidcheck.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <string>
#include <utility>
#include <vector>

namespace rastertrace {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;
using testing::SizeIs;

/// What is told of a scene drawn by the top-left rule: "PQ of PQT: M 0.025; PMB MQB".
std::vector<std::string> junctions_in(const std::string& vertices, const std::string& triangles,
                                      const std::string& method = "") {
    const std::string json =
        R"({"canvas":{"width":64,"height":96,"origin":"top-left"},"vertices":{)" + vertices +
        R"(},"triangles":[)" + triangles + R"(],"method":{"fill":"top-left")" + method + "}}";
    std::vector<std::string> told;
    for (const EdgeWithJunctions& edge : stats_of_scene(scene_in(json)).t_junctions) {
        std::string text = edge.name + " of " + edge.triangle + ":";
        for (const VertexOnEdge& vertex : edge.vertices)
            text += fmt::format(" {} {}", vertex.name, vertex.distance);
        text += ";";
        for (const std::string& triangle : edge.beside)
            text += " " + triangle;
        told.push_back(text);
    }
    return told;
}

/// Two triangles below an edge PQ, and PQT above it; the catalogue's C15.
EdgeWithJunctions c15(const std::string& m, const std::string& scalar = "exact") {
    const Stats stats = stats_of_scene(scene_in(
        R"({"canvas":{"width":64,"height":96,"origin":"top-left"},"vertices":{"P":[0,20],)"
        R"("Q":[40,27],"T":[32,-20],"B":[32,90],"M":[)" +
        m + R"(]},"triangles":["PQT","PMB","MQB"],"method":{"fill":"top-left","scalar":")" +
        scalar + "\"}}"));
    EXPECT_THAT(stats.t_junctions, SizeIs(1));
    return stats.t_junctions.at(0);
}

// y = 20 + 7x/40 is 21.225 at x = 7 and 25.775 at x = 33.
TEST(TJunction, AVertexRoundedToOneSideLeavesAPixelOutOrDrawsItTwice) {
    const EdgeWithJunctions below = c15(R"(7, "85/4")");
    EXPECT_EQ(below.name, "PQ");
    EXPECT_EQ(below.triangle, "PQT");
    ASSERT_EQ(below.vertices.size(), 1u);
    EXPECT_EQ(below.vertices[0].name, "M");
    EXPECT_EQ(below.vertices[0].distance, 0.025);
    EXPECT_THAT(below.beside, ElementsAre("PMB", "MQB"));
    EXPECT_EQ(below.twice.count, 0u);
    EXPECT_EQ(below.never.count, 1u);

    const EdgeWithJunctions above = c15(R"(33, "103/4")");
    EXPECT_EQ(above.vertices[0].distance, 0.025);
    EXPECT_EQ(above.twice.count, 1u);
    EXPECT_EQ(above.never.count, 0u);
}

TEST(TJunction, IsToldEvenIfNoPixelIsWrong) {
    const EdgeWithJunctions on = c15(R"(7, "849/40")");
    EXPECT_EQ(on.vertices[0].distance, 0.0);
    EXPECT_EQ(on.twice.count, 0u);
    EXPECT_EQ(on.never.count, 0u);
}

TEST(TJunction, IsNoneWhereEdgesAreShared) {
    const std::string vertices =
        R"("P":[0,20],"Q":[40,27],"T":[32,-20],"B":[32,90],"M":[7,"85/4"])";
    EXPECT_THAT(junctions_in(vertices, R"("PMT","MQT","PMB","MQB")"), IsEmpty());
    EXPECT_THAT(junctions_in(vertices, R"("PQT","PQB")"), IsEmpty());
    // The sliver between closes the gap.
    EXPECT_THAT(junctions_in(vertices, R"("PQT","PMQ","PMB","MQB")"), IsEmpty());
    EXPECT_THAT(junctions_in(vertices, R"("PQT","PMB","MQB")"),
                ElementsAre("PQ of PQT: M 0.025; PMB MQB"));
    // One without area closes it as well, wherever rounding moves its vertices.
    const std::string exact = R"("P":[0,20],"Q":[40,28],"T":[32,-20],"B":[32,90],"M":[10,22])";
    EXPECT_THAT(junctions_in(exact, R"("PQT","PMQ","PMB","MQB")"), IsEmpty());
    EXPECT_THAT(junctions_in(exact, R"("PQT","PMB","MQB")"),
                ElementsAre("PQ of PQT: M 0; PMB MQB"));
}

TEST(TJunction, SeveralVerticesLieOnOneEdge) {
    const std::string vertices = R"("P":[40,27],"Q":[0,20],"T":[32,-20],"B":[32,90],"K":[7,21.25],)"
                                 R"("M":[21,23.5],"N":[33,25.75])";
    EXPECT_THAT(junctions_in(vertices, R"("BQK","KMB","TPQ","NBM","BPN")"),
                ElementsAre("PQ of TPQ: N 0.025 M 0.175 K 0.025; BPN NBM KMB BQK"));
}

TEST(TJunction, BothSidesMayHaveVertices) {
    EXPECT_THAT(
        junctions_in(R"("P":[0,20],"K":[10,20.25],"L":[20,20.25],"M":[30,20.5],"Q":[40,20],)"
                     R"("T":[20,0],"B":[20,50])",
                     R"("PLT","LQT","PKB","KMB","MQB")"),
        ElementsAre("PL of PLT: K 0.125; PKB KMB", "LQ of LQT: M 0.375; KMB MQB",
                    "KM of KMB: L 0.125; PLT LQT"));
}

// Bricks: no two of them have a vertex in common.
TEST(TJunction, NoVertexNeedBeShared) {
    const std::string vertices = R"("A":[0,10],"B":[8,12],"C":[4,2],"D":[2,10.5],"E":[6,11.5],)"
                                 R"("F":[4,22],"G":[12,13],"H":[8,22])";
    EXPECT_THAT(junctions_in(vertices, R"("ABC","DEF")"), ElementsAre("AB of ABC: D 0 E 0; DEF"));
    EXPECT_THAT(junctions_in(vertices, R"("ABC","EGH")"),
                ElementsAre("AB of ABC: E 0; EGH", "EG of EGH: B 0; ABC"));
    EXPECT_THAT(junctions_in(vertices, R"("ABC","DEF")", R"(,"scalar":"fixed")"),
                ElementsAre("AB of ABC: D 0 E 0; DEF"));
}

TEST(TJunction, SnappedToTheGridItIsStillOne) {
    const std::string vertices = R"("A":[0.001,10.003],"B":[8.123,12.0335],"C":[4,2],)"
                                 R"("D":[2.002,10.50325],"E":[6.002,11.50325],"F":[4,22])";
    for (const std::string scalar : {"exact", "adaptive", "fixed", "float", "double"})
        EXPECT_THAT(junctions_in(vertices, R"("ABC","DEF")", R"(,"scalar":")" + scalar + "\""),
                    SizeIs(1))
            << scalar;
}

TEST(TJunction, WhatMerelyPassesIsNone) {
    const std::string floor = R"("A":[0,10],"B":[16,10],"C":[8,2],)";
    const auto told = [&floor](const std::string& vertices) {
        return junctions_in(floor + vertices, R"("ABC","DEF")").size();
    };
    EXPECT_EQ(told(R"("D":[2,10],"E":[6,10],"F":[4,20])"), 1u);
    EXPECT_EQ(told(R"("D":[2,10.25],"E":[6,10.25],"F":[4,20])"), 0u) << "a quarter pixel below";
    EXPECT_EQ(told(R"("D":[2,10],"E":[6,10.5],"F":[4,20])"), 0u) << "it touches in one vertex";
    EXPECT_EQ(told(R"("D":[2,10],"E":[6,10],"F":[4,3])"), 0u) << "on the same side";
    EXPECT_EQ(told(R"("D":[16,10],"E":[20,10],"F":[18,20])"), 0u) << "end to end";
    EXPECT_EQ(told(R"("D":[17,10],"E":[20,10],"F":[18,20])"), 0u) << "beyond";
    EXPECT_EQ(told(R"("D":[0.001,10],"E":[15.999,10],"F":[8,20])"), 0u) << "ends meant to be one";
}

TEST(TJunction, ASliverHasNoneWithItself) {
    EXPECT_THAT(junctions_in(R"("P":[0,20],"Q":[40,20],"M":[20,20.001])", R"("PQM")"), IsEmpty());
    EXPECT_THAT(junctions_in(R"("P":[0,20],"Q":[40,20],"M":[20,20.25])", R"("PQM")"), IsEmpty());
}

// From a common end: a row that comes back to the edge is one edge with it, another is a corner.
TEST(TJunction, ARowThatPartsAndDoesNotMeetIsACorner) {
    const std::string vertices = R"("P":[0,20],"Q":[40,20],"T":[20,0],"B":[20,50],"M":[20,20.5],)"
                                 R"("N":[20,20.001],"O":[20,20.75],"K":[2,20.375])";
    EXPECT_THAT(junctions_in(vertices, R"("PQT","PMB","MQB")"),
                ElementsAre("PQ of PQT: M 0.5; PMB MQB"));
    EXPECT_THAT(junctions_in(vertices, R"("PQT","PMB")"), IsEmpty());
    EXPECT_THAT(junctions_in(vertices, R"("PQT","PNB")"), ElementsAre("PQ of PQT: N 0.001; PNB"));
    EXPECT_THAT(junctions_in(vertices, R"("PQT","POB","OQB")"), IsEmpty()) << "3/4 px";
    // A hole of the mesh, smaller than a pixel.
    EXPECT_THAT(junctions_in(R"("P":[0,20],"Q":[1,20],"M":[0.5,20.25],"T":[0,0],"B":[0,50])",
                             R"("PQT","PMB","MQB")"),
                IsEmpty());
}

TEST(TJunction, CulledTrianglesAreNeighborsAllTheSame) {
    const auto told = [](const std::string& triangles) {
        return junctions_in(R"("P":[0,20],"Q":[40,20],"T":[20,0],"B":[20,50],"M":[20,20.25])",
                            triangles, R"(,"cull":"back")")
            .size();
    };
    EXPECT_EQ(told(R"("PQT","PBM","MBQ")") + told(R"("PTQ","PMB","MQB")"), 1u);
    for (const std::string between : {R"("PMQ")", R"("PQM")"}) {
        EXPECT_EQ(told(R"("PQT","PBM","MBQ",)" + between), 0u);
        EXPECT_EQ(told(R"("PTQ","PMB","MQB",)" + between), 0u);
    }
}

// As many as a large mesh has, each with its own; found by looking at each edge once.
TEST(TJunction, InALargeMeshEachIsTold) {
    // A row of squares of 4, on a row of squares of 2; and rows of that.
    Scene scene;
    scene.canvas = {.width = 100, .height = 100, .origin = Origin::bottom_left};
    scene.method = {.scalar = ScalarKind::fixed, .fill = Fill::top_left};
    const auto square = [&scene](int x, int y, int size) {
        const std::size_t first = scene.vertices.size();
        for (const auto& [right, up] : {std::pair{0, 0}, {size, 0}, {size, size}, {0, size}})
            scene.vertices.push_back(
                {"V" + std::to_string(scene.vertices.size()), x + right, y + up});
        for (const std::size_t corner : {1U, 2U})
            scene.primitives.push_back({.kind = PrimitiveKind::triangle,
                                        .name = "T" + std::to_string(scene.primitives.size()),
                                        .vertices = {first, first + corner, first + corner + 1}});
    };
    for (int y = 0; y < 96; y += 6) {
        for (int x = 0; x < 96; x += 4)
            square(x, y, 4);
        for (int x = 0; x < 96; x += 2)
            square(x, y + 4, 2);
    }
    // Above and below each large square but those of the first row, whose lower side is the end.
    const Stats stats = stats_of_scene(scene);
    EXPECT_EQ(stats.t_junctions.size(), (16 + 15) * 24u);
    for (const EdgeWithJunctions& edge : stats.t_junctions) {
        EXPECT_THAT(edge.vertices, SizeIs(1));
        EXPECT_THAT(edge.beside, SizeIs(2));
        EXPECT_EQ(edge.twice.count + edge.never.count, 0u);
    }
}

using Point = std::array<mpq_class, 2>;

mpq_class turn(const Point& a, const Point& b, const Point& c) {
    return (b[0] - a[0]) * (c[1] - a[1]) - (c[0] - a[0]) * (b[1] - a[1]);
}

/// Where a row of points from left to right lies at x.
mpq_class height_at(const std::vector<Point>& row, const mpq_class& x) {
    std::size_t i = 1;
    while (i + 1 < row.size() && row[i][0] < x)
        ++i;
    return row[i - 1][1] +
           (row[i][1] - row[i - 1][1]) * (x - row[i - 1][0]) / (row[i][0] - row[i - 1][0]);
}

// A triangle above an edge and a row of them below, turned and mirrored, in any order; every pixel of
// the canvas is looked at by itself.
RC_GTEST_PROP(TJunction, AgreesWithEveryPixelTestedByItself, ()) {
    const auto part = [](int low, int high, int of) {
        return mpq_class(*rc::gen::inRange(low, high + 1), of);
    };
    const mpq_class rise = part(-40, 40, 4); // at most as steep as 10 in 16
    const mpq_class left = part(0, 12, 4);
    const mpq_class width = 16 + part(0, 8, 4);
    const mpq_class start = 10 + part(0, 8, 4);
    const auto on_edge = [&](const mpq_class& x) {
        return mpq_class(start + rise * (x - left) / width);
    };
    std::vector<Point> row{{left, start}};
    std::vector<std::string> names{"P"};
    const int between = *rc::gen::inRange(1, 4);
    for (int i = 1; i <= between; ++i) {
        const mpq_class x = left + width * i / (between + 1) + part(-4, 4, 4);
        row.push_back({x, on_edge(x) + part(-4, 4, 8)});
        names.push_back("M" + std::to_string(i));
    }
    row.push_back({left + width, on_edge(left + width)});
    names.push_back("Q");
    const std::vector<Point> edge{row.front(), row.back()};
    const Point above{left + part(0, 80, 4), mpq_class(-30)};
    const Point below{left + part(0, 80, 4), mpq_class(60)};

    // On the canvas: x and y in place of each other, and y up or down.
    const bool is_steep = *rc::gen::arbitrary<bool>();
    const Origin origin = *rc::gen::element(Origin::top_left, Origin::bottom_left);
    const Fill fill = *rc::gen::element(Fill::top_left, Fill::barycentric, Fill::scanline);
    Scene scene;
    scene.canvas = {.width = 30, .height = 30, .origin = origin};
    scene.method = {.scalar = ScalarKind::exact, .fill = fill};
    const auto add_vertex = [&](const std::string& name, const Point& at) {
        scene.vertices.push_back(
            {name, number(at[is_steep ? 1 : 0].get_str()), number(at[is_steep ? 0 : 1].get_str())});
        return scene.vertices.size() - 1;
    };
    for (std::size_t i = 0; i < row.size(); ++i)
        add_vertex(names[i], row[i]);
    const std::size_t t = add_vertex("T", above);
    const std::size_t b = add_vertex("B", below);
    const auto add_triangle = [&](std::array<std::size_t, 3> corners) {
        std::rotate(corners.begin(), corners.begin() + *rc::gen::inRange(0, 3), corners.end());
        if (*rc::gen::arbitrary<bool>())
            std::swap(corners[0], corners[1]);
        scene.primitives.push_back({.kind = PrimitiveKind::triangle,
                                    .name = "S" + std::to_string(scene.primitives.size()),
                                    .vertices = corners});
    };
    add_triangle({0, row.size() - 1, t});
    for (std::size_t i = 1; i < row.size(); ++i)
        add_triangle({i - 1, i, b});

    log_scene(scene);

    // Who draws which pixel.
    std::vector<Image> images;
    for (const ScenePrimitive& primitive : scene.primitives) {
        Scene alone = scene;
        alone.primitives = {primitive};
        images.push_back(draw_as_planned(alone));
    }
    const mpq_class offset = fill == Fill::top_left ? mpq_class(1, 2) : mpq_class(0);
    std::vector<Pixel> twice;
    std::vector<Pixel> never;
    for (int line = 0; line < 30; ++line)
        for (int x = 0; x < 30; ++x) {
            const Pixel pixel{x, scene.canvas.y_of(line)};
            Point sample{pixel.x + offset, pixel.y + offset};
            if (is_steep)
                std::swap(sample[0], sample[1]);
            const bool by_upper = images[0].at(pixel) != no_color;
            const bool by_lower =
                std::any_of(images.begin() + 1, images.end(),
                            [&](const Image& image) { return image.at(pixel) != no_color; });
            if (by_upper && by_lower)
                twice.push_back(pixel);
            const bool is_beside = left <= sample[0] && sample[0] <= left + width &&
                                   abs(sample[1] - on_edge(sample[0])) <= 1;
            if (by_upper || by_lower || !is_beside)
                continue;
            bool is_missed = left < sample[0] && sample[0] < left + width &&
                             on_edge(sample[0]) <= sample[1] &&
                             sample[1] <= height_at(row, sample[0]);
            const auto is_inside = [&sample](const Point& p, const Point& q, const Point& r) {
                const int side = sgn(turn(p, q, r));
                return sgn(turn(p, q, sample)) == side && sgn(turn(q, r, sample)) == side &&
                       sgn(turn(r, p, sample)) == side;
            };
            is_missed = is_missed || is_inside(row.front(), row.back(), above);
            for (std::size_t i = 1; i < row.size(); ++i)
                is_missed = is_missed || is_inside(row[i - 1], row[i], below);
            if (is_missed)
                never.push_back(pixel);
        }

    // The edge is at least 16 long, so that half a pixel is near.
    const Stats stats = stats_of_scene(scene);
    RC_ASSERT(stats.t_junctions.size() == 1u);
    const EdgeWithJunctions& found = stats.t_junctions[0];
    RC_ASSERT(found.triangle == "S0");
    RC_ASSERT(found.vertices.size() == row.size() - 2);
    RC_ASSERT(found.beside.size() == row.size() - 1);
    for (const VertexOnEdge& vertex : found.vertices) {
        const auto name = std::find(names.begin(), names.end(), vertex.name);
        const Point& at = row[static_cast<std::size_t>(name - names.begin())];
        RC_ASSERT(vertex.distance == mpq_class(abs(at[1] - on_edge(at[0]))).get_d());
    }
    RC_ASSERT(found.twice.kept == twice);
    RC_ASSERT(found.never.kept == never);
    RC_CLASSIFY(!never.empty(), "some are in none");
    RC_CLASSIFY(!twice.empty(), "some are in two");
}

} // namespace
} // namespace rastertrace
