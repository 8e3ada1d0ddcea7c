// SPDX-License-Identifier: MIT
// Vertices exactly on edges that have no vertex there: which are told of, and what is none.

#include "stats_of_scene.h"
#include "traces.h"

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cstddef>
#include <cstdlib>
#include <string>
#include <utility>
#include <vector>

namespace rastertrace {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;
using testing::SizeIs;

/// What is told of a scene drawn by the top-left rule: "PQ of PQT: M; PMB MQB".
std::vector<std::string> junctions_in(const std::string& vertices, const std::string& triangles,
                                      const std::string& method = "") {
    const std::string json =
        R"({"canvas":{"width":64,"height":96,"origin":"top-left"},"vertices":{)" + vertices +
        R"(},"triangles":[)" + triangles + R"(],"method":{"fill":"top-left")" + method + "}}";
    std::vector<std::string> told;
    for (const EdgeWithJunctions& edge : stats_of_scene(scene_in(json)).t_junctions)
        told.push_back(fmt::format("{} of {}: {}; {}", edge.name, edge.triangle,
                                   fmt::join(edge.vertices, " "), fmt::join(edge.beside, " ")));
    return told;
}

// The edge is y = 20 + 7x/40; the catalogue's C15 rounds M.
TEST(TJunction, IsAVertexExactlyOnAnEdge) {
    const auto told = [](const std::string& m) {
        return junctions_in(R"("P":[0,20],"Q":[40,27],"T":[32,-20],"B":[32,90],"M":[)" + m + "]",
                            R"("PQT","PMB","MQB")", R"(,"scalar":"exact")");
    };
    EXPECT_THAT(told(R"(7, "849/40")"), ElementsAre("PQ of PQT: M; PMB MQB"));
    EXPECT_THAT(told(R"(33, "1031/40")"), ElementsAre("PQ of PQT: M; PMB MQB"));
    EXPECT_THAT(told(R"(7, "85/4")"), IsEmpty());
    EXPECT_THAT(told(R"(7, "212250000000000001/10000000000000000")"), IsEmpty());
}

TEST(TJunction, IsNoneWhereEdgesAreShared) {
    const std::string vertices = R"("P":[0,20],"Q":[40,28],"T":[32,-20],"B":[32,90],"M":[10,22])";
    EXPECT_THAT(junctions_in(vertices, R"("PMT","MQT","PMB","MQB")"), IsEmpty());
    EXPECT_THAT(junctions_in(vertices, R"("PQT","PQB")"), IsEmpty());
    EXPECT_THAT(junctions_in(vertices, R"("PQT","PMB","MQB")"),
                ElementsAre("PQ of PQT: M; PMB MQB"));
    // A triangle without area has all three edges.
    EXPECT_THAT(junctions_in(vertices, R"("PQT","PMQ","PMB","MQB")"), IsEmpty());
}

TEST(TJunction, SeveralVerticesLieOnOneEdge) {
    const std::string vertices = R"("P":[40,28],"Q":[0,20],"T":[32,-20],"B":[32,90],"K":[5,21],)"
                                 R"("M":[20,24],"N":[35,27])";
    EXPECT_THAT(junctions_in(vertices, R"("BQK","KMB","TPQ","NBM","BPN")"),
                ElementsAre("PQ of TPQ: N M K; BPN NBM KMB BQK"));
}

TEST(TJunction, BothSidesMayHaveVertices) {
    for (const std::string at : {R"("P":[0,20],"K":[10,20],"L":[20,20],"M":[30,20],"Q":[40,20],)",
                                 R"("P":[20,0],"K":[20,10],"L":[20,20],"M":[20,30],"Q":[20,40],)"})
        EXPECT_THAT(
            junctions_in(at + R"("T":[5,5],"B":[60,50])", R"("PLT","LQT","PKB","KMB","MQB")"),
            ElementsAre("PL of PLT: K; PKB KMB", "LQ of LQT: M; KMB MQB", "KM of KMB: L; PLT LQT"));
}

// Bricks: no two of them have a vertex in common.
TEST(TJunction, NoVertexNeedBeShared) {
    const std::string vertices = R"("A":[0,10],"B":[8,12],"C":[4,2],"D":[2,10.5],"E":[6,11.5],)"
                                 R"("F":[4,22],"G":[12,13],"H":[8,22])";
    EXPECT_THAT(junctions_in(vertices, R"("ABC","DEF")"), ElementsAre("AB of ABC: D E; DEF"));
    EXPECT_THAT(junctions_in(vertices, R"("ABC","EGH")"),
                ElementsAre("AB of ABC: E; EGH", "EG of EGH: B; ABC"));
    EXPECT_THAT(junctions_in(vertices, R"("ABC","DEF")", R"(,"scalar":"fixed")"),
                ElementsAre("AB of ABC: D E; DEF"));
}

TEST(TJunction, WhatMerelyPassesIsNone) {
    const std::string floor = R"("A":[0,10],"B":[16,10],"C":[8,2],)";
    const auto told = [&floor](const std::string& vertices) {
        return junctions_in(floor + vertices, R"("ABC","DEF")").size();
    };
    EXPECT_EQ(told(R"("D":[2,10],"E":[6,10],"F":[4,20])"), 1u);
    EXPECT_EQ(told(R"("D":[2,10.001],"E":[6,10.001],"F":[4,20])"), 0u) << "a little below";
    EXPECT_EQ(told(R"("D":[2,10],"E":[6,10.5],"F":[4,20])"), 0u) << "it touches in one vertex";
    EXPECT_EQ(told(R"("D":[2,10],"E":[6,10],"F":[4,3])"), 0u) << "on the same side";
    EXPECT_EQ(told(R"("D":[16,10],"E":[20,10],"F":[18,20])"), 0u) << "end to end";
    EXPECT_EQ(told(R"("D":[17,10],"E":[20,10],"F":[18,20])"), 0u) << "beyond";
}

TEST(TJunction, CulledTrianglesAreNeighborsAllTheSame) {
    const auto told = [](const std::string& triangles) {
        return junctions_in(R"("P":[0,20],"Q":[40,20],"T":[20,0],"B":[20,50],"M":[20,20])",
                            triangles, R"(,"cull":"back")")
            .size();
    };
    EXPECT_EQ(told(R"("PQT","PBM","MBQ")") + told(R"("PTQ","PMB","MQB")"), 1u);
    for (const std::string other : {R"("PQB")", R"("PBQ")"}) {
        EXPECT_EQ(told(R"("PQT","PBM","MBQ",)" + other), 0u);
        EXPECT_EQ(told(R"("PTQ","PMB","MQB",)" + other), 0u);
    }
}

// As a foreign rasterizer might: of the edge from (0, 4) to (8, 4) it draws one pixel, twice, and it
// leaves out (5, 3) above it.
TEST(TJunction, IsToldWithThePixelsInTwoTrianglesAndInNone) {
    std::string text = foreign_header;
    const auto draw = [&text](const std::string& name, const std::string& at, auto is_in) {
        text += foreign_triangle(name, at, [is_in](int x, int y) {
            return is_in(x, y) && Pixel{x, y} != Pixel{5, 3};
        });
    };
    const auto is_twice = [](int x, int y) { return x == 3 && y == 4; };
    draw("upper", "[[0,4],[8,4],[4,0]]",
         [&](int x, int y) { return (y < 4 && std::abs(x - 4) <= y) || is_twice(x, y); });
    draw("left", "[[0,4],[4,4],[4,8]]",
         [&](int x, int y) { return (y > 4 && x <= 4 && x >= y - 4) || is_twice(x, y); });
    draw("right", "[[4,4],[8,4],[4,8]]",
         [](int x, int y) { return y > 4 && x > 4 && x <= 12 - y; });
    const Stats stats = stats_of(readable_trace(text + "{\"end\":{}}\n"));
    ASSERT_EQ(stats.t_junctions.size(), 1u);
    EXPECT_EQ(stats.t_junctions[0].name, "(0, 4)-(8, 4)");
    EXPECT_THAT(stats.t_junctions[0].vertices, ElementsAre("(4, 4)"));
    EXPECT_THAT(stats.t_junctions[0].beside, ElementsAre("left", "right"));
    EXPECT_THAT(stats.t_junctions[0].twice.kept, ElementsAre(Pixel{3, 4}));
    EXPECT_THAT(
        stats.t_junctions[0].never.kept,
        ElementsAre(Pixel{5, 3}, Pixel{1, 4}, Pixel{2, 4}, Pixel{5, 4}, Pixel{6, 4}, Pixel{7, 4}));
}

// A vertex on n edges would be told of n times, and n vertices on each of them n^2 times.
TEST(TJunction, OfEdgesOnOneAnotherSomeAreTold) {
    std::string vertices = R"("T":[32,0],"B":[32,90])";
    std::string triangles;
    for (int i = 0; i < 20; ++i) {
        vertices += fmt::format(R"(,"L{0}":[{0},40],"R{0}":[{1},40])", i, 64 - i);
        triangles +=
            fmt::format(R"({}["L{}","R{}","{}"])", i == 0 ? "" : ",", i, i, i % 2 == 0 ? "T" : "B");
    }
    const auto told = junctions_in(vertices, triangles);
    EXPECT_THAT(told, SizeIs(16u)); // eight on either side
}

// As many as a large mesh has, each with its own.
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

} // namespace
} // namespace rastertrace
