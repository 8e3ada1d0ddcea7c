// SPDX-License-Identifier: MIT
// Where a scene is near a cliff, and that it says so only there.

#include <rastertrace/numerics/cliffs.h>
#include <rastertrace/numerics/stress.h>
#include <rastertrace/trace/scene/scene_file.h>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

namespace rastertrace {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

/// A scene of a triangle ABC by a method; canvas 16x16, y down.
std::string triangle(const std::string& a, const std::string& b, const std::string& c,
                     const std::string& method = R"("fill":"top-left")") {
    return R"({"canvas":{"width":16,"height":16,"origin":"top-left"},"vertices":{"A":[)" + a +
           R"(],"B":[)" + b + R"(],"C":[)" + c + R"(]},"triangles":["ABC"],"method":{)" + method +
           "}}";
}

std::vector<CliffGroup> cliffs_in(const std::string& json) {
    const auto scene = read_scene({"scene.json", json}, {{"scalar", "exact"}});
    if (!scene)
        throw scene.problem();
    return cliffs_of(scene.value().scene);
}

std::vector<std::string> kinds_in(const std::string& json) {
    std::vector<std::string> kinds;
    for (const CliffGroup& group : cliffs_in(json))
        kinds.emplace_back(name_of(group.kind));
    return kinds;
}

/// The worst of a kind: "where: how near", or "" if there is none.
std::string worst_of(CliffKind kind, const std::string& json) {
    for (const CliffGroup& group : cliffs_in(json))
        if (group.kind == kind)
            return group.worst.front().where + ": " + group.worst.front().how_near;
    return "";
}

TEST(Cliffs, ThereAreNoneInAnOrdinaryTriangle) {
    EXPECT_THAT(kinds_in(triangle("1.25, 1.75", "13.5, 3.25", "4.75, 12.5")), IsEmpty());
}

TEST(Cliffs, ASampleOnAnEdgeOrWithin2ToTheMinus20) {
    EXPECT_EQ(worst_of(CliffKind::sample_on_edge, triangle("0, 0", "8, 8", "2, 15.25")),
              "edge AB of triangle ABC: passes exactly through 8 samples, one at pixel (0, 0)");
    // The edge is moved up by 2^-21 px: its 8 samples lie below it.
    EXPECT_EQ(worst_of(CliffKind::sample_on_edge,
                       triangle(R"(0, "-1/2097152")", R"(8, "16777215/2097152")", "2, 15.25")),
              "edge AB of triangle ABC: comes within 2^-20 px of 8 samples, the nearest 4.8e-07 px "
              "away, at pixel (0, 0)");
    // By 2^-19 it is no longer near.
    EXPECT_THAT(kinds_in(triangle(R"(0, "-1/524288")", R"(8, "4194303/524288")", "2, 15.25")),
                ElementsAre("snapped"));
}

TEST(Cliffs, ARowThatEndsOnAPixelAndAnEdgeOnARow) {
    const auto groups = cliffs_in(triangle("2, 2", "9.5, 2", "2.25, 12.5", R"("fill":"scanline")"));
    ASSERT_EQ(groups.size(), 1u);
    EXPECT_EQ(groups[0].worst[0].how_near, "lies on row 2");
    EXPECT_EQ(groups[0].worst[1].how_near, "passes exactly through 1 row end, one at pixel (2, 2)");
}

TEST(Cliffs, TiesOfALine) {
    const auto line = [](const std::string& method) {
        return R"({"canvas":{"width":64,"height":16,"origin":"bottom-left"},"vertices":{"A":[0,0],)"
               R"("B":[60,10]},"lines":["AB"],"method":{)" +
               method + "}}";
    };
    for (const std::string method : {R"("line":"bresenham")", R"("line":"naive")"})
        EXPECT_EQ(worst_of(CliffKind::sample_on_edge, line(method)),
                  "line AB: passes exactly through 10 ties, one at pixel (3, 0)");
}

TEST(Cliffs, SlopesOfAMillion) {
    EXPECT_EQ(worst_of(CliffKind::slope, triangle("0, 0.25", "1e6, 1.25", "0, 12.25")),
              "edge AB of triangle ABC: dx/dy = 1e+06");
    EXPECT_EQ(worst_of(CliffKind::slope, triangle("0, 0.25", "999999, 1.25", "0, 12.25")), "");
    EXPECT_EQ(worst_of(CliffKind::slope, triangle("0.25, 0", "1.25, 1e6", "9.25, 7")),
              "edge AB of triangle ABC: dx/dy = 1e-06");
}

TEST(Cliffs, AStepThatIsAbsorbed) {
    EXPECT_EQ(worst_of(CliffKind::absorbed_step,
                       triangle("8388.5, 0.25", "8389.5, 1000.25", "9, 1000.25")),
              "edge AB of triangle ABC: dx/dy = 0.001 is added to 8389.5: absorbed in float");
    EXPECT_EQ(worst_of(CliffKind::absorbed_step,
                       triangle("8387.25, 0.25", "8388.25, 1000.25", "9, 1000.25")),
              "");
}

TEST(Cliffs, AnErrorThatGrowsToTheNextTie) {
    const auto edge = [](const std::string& method) {
        return R"({"canvas":{"width":1001,"height":3001,"origin":"top-left"},"vertices":{"A":[0,0],)"
               R"("B":[1000,3000],"C":[0,3000]},"triangles":["ABC"],"method":{)" +
               method + "}}";
    };
    EXPECT_THAT(
        worst_of(CliffKind::growing_error, edge(R"("lerp":"incremental")")),
        HasSubstr("edge AB of triangle ABC: 3000 steps of 0.333 may be off by 0.18 px, and a "
                  "tie lies within 0.00017 px: float"));
    EXPECT_EQ(worst_of(CliffKind::growing_error, edge(R"("lerp":"direct")")), "")
        << "multiplied, nothing grows";
}

TEST(Cliffs, TrianglesOfAlmostNoArea) {
    EXPECT_EQ(worst_of(CliffKind::sliver, triangle("0, 0", "2584, 4181", "4181, 6765")),
              "triangle ABC: twice its area is 1, the difference of products of 1.75e+07: lost in "
              "float");
    EXPECT_THAT(worst_of(CliffKind::sliver,
                         triangle("0, 0", "102334155, 165580141", "165580141, 267914296")),
                HasSubstr("lost in float and double"));
    EXPECT_EQ(worst_of(CliffKind::sliver, triangle("0, 0", "4, 4", "8, 8")),
              "triangle ABC: its area is 0");
}

TEST(Cliffs, WhatFixedMovesOrLeavesNothingOf) {
    const std::string json = triangle("0.5, 0.5", R"("513/1024", 0.5)", R"(0.5, "513/1024")");
    EXPECT_EQ(worst_of(CliffKind::snapped, json),
              "vertex B: at (0.500976562, 0.5) moves by 0.000977 px");
    EXPECT_EQ(worst_of(CliffKind::collapsed, json),
              "triangle ABC: twice its area is 9.54e-07 px^2, and 0 on the grid of 1/256");
}

TEST(Cliffs, CoordinatesBeyond2ToThe23) {
    EXPECT_EQ(worst_of(CliffKind::far_out, triangle("0, 0", "8388610, 1", "3, 9")),
              "vertex B: at (8.38861e+06, 1): float's next number is 1 px away");
    EXPECT_EQ(worst_of(CliffKind::far_out, triangle("0, 0", "8388608, 1", "3, 9")), "");
}

TEST(Cliffs, DepthsOneToAMillion) {
    const auto deep = [](const std::string& z) {
        return triangle("1.25, 1.75, 1", "13.5, 3.25, " + z, "4.75, 12.5, 1",
                        R"("fill":"top-left","depth":"inverse-z")");
    };
    EXPECT_EQ(worst_of(CliffKind::depth_ratio, deep("1000000")),
              "triangle ABC: depths from 1 to 1e+06: 1 to 1e+06");
    EXPECT_THAT(kinds_in(deep("999999")), IsEmpty());
}

/// A triangle seen in a perspective; the eye is the origin.
std::string seen(const std::string& a, const std::string& b, const std::string& c) {
    return R"({"canvas":{"width":16,"height":16},"vertices":{"A":[)" + a + R"(],"B":[)" + b +
           R"(],"C":[)" + c +
           R"(]},"triangles":["ABC"],"projection":{"type":"frustum","left":-1,"right":1,)"
           R"("bottom":-1,"top":1,"near":1,"far":"infinity"},"method":{"fill":"top-left"}})";
}

TEST(Cliffs, FacesSeenFromTheirEdge) {
    EXPECT_EQ(worst_of(CliffKind::edge_on, seen("-1, 0, -4", "1, 0, -4", "0, 0, -6")),
              "triangle ABC: seen exactly from its edge: normal . view = 0");
    EXPECT_THAT(worst_of(CliffKind::edge_on, seen("-1, 1e-7, -4", "1, 1e-7, -4", "0, 1e-7, -6")),
                HasSubstr("triangle ABC: normal . view = -4e-07, cosine -2.14e-08"));
    EXPECT_EQ(worst_of(CliffKind::edge_on, seen("-1, 0.01, -4", "1, 0.01, -4", "0, 0.01, -6")), "");
}

// In clip space x, y and w are a view from (0, 0, 0): a face is seen from its edge if they lie in one plane
// with that, whatever z is.
TEST(Cliffs, FacesInClipSpaceAreSeenFromTheirEdgeWhereTheScreenHasThemSo) {
    const auto clip = [](const std::string& a, const std::string& b, const std::string& c) {
        return R"({"canvas":{"width":8,"height":8},"convention":"opengl","vertices":{"A":[)" + a +
               R"(],"B":[)" + b + R"(],"C":[)" + c + R"(]},"triangles":["ABC"]})";
    };
    for (const std::string z : {"0", "0.25"})
        EXPECT_EQ(
            worst_of(CliffKind::edge_on, clip("-0.5, 0.5, " + z + ", 1", "0.5, -0.5, " + z + ", 1",
                                              "-0.5, -0.5, " + z + ", 1")),
            "");
    // The determinant of x, y and w is -1. Then y = w/8 in all three.
    EXPECT_EQ(worst_of(CliffKind::edge_on, clip("1, 0, 0, 2", "0, 1, 0, 2", "1, 1, 0, 3")), "");
    EXPECT_EQ(worst_of(CliffKind::edge_on, clip("-1, 0.25, 0, 2", "1, 0.5, 1, 4", "0, 0.25, 0, 2")),
              "triangle ABC: seen exactly from its edge: normal . view = 0");
}

TEST(Cliffs, VerticesAtTheNearPlaneAndBehindTheEye) {
    EXPECT_EQ(worst_of(CliffKind::near_plane, seen("-1, -1, -4", "1, -1, -4", "0, 1, -1")),
              "vertex C: on the near plane");
    EXPECT_EQ(worst_of(CliffKind::near_plane, seen("-1, -1, -4", "1, -1, -4", "0, 1, 2")),
              "vertex C: behind the eye, at -2, cut off by the near plane at 1");
    EXPECT_EQ(worst_of(CliffKind::near_plane, seen("-1, -1, -4", "1, -1, -4", "0, 1, -0.5")),
              "vertex C: at distance 0.5, cut off by the near plane at 1");
    EXPECT_EQ(worst_of(CliffKind::near_plane, seen("-1, -1, -4", "1, -1, -4", "0, 1, 0")),
              "vertex C: w = 0, with x or y = 1: as good as beside the eye");
    EXPECT_EQ(worst_of(CliffKind::near_plane, seen("-1, -1, -4", "1, -1, -4", "0, 1, -2")), "");
}

// A shared edge is one edge, and of many only the worst are kept.
TEST(Cliffs, AreListedOnceAndWorstFirst) {
    std::string vertices = R"("O":[0,0])";
    std::string triangles;
    for (int i = 0; i <= 50; ++i) {
        const std::string name = "P" + std::to_string(i);
        vertices += ",\"" + name + "\":[64," + std::to_string(i) + "]";
        if (i > 0)
            triangles += std::string(i > 1 ? "," : "") + R"(["O","P)" + std::to_string(i - 1) +
                         R"(","P)" + std::to_string(i) + R"("])";
    }
    const auto groups = cliffs_in(R"({"canvas":{"width":65,"height":65,"origin":"top-left"},)"
                                  R"("vertices":{)" +
                                  vertices + R"(},"triangles":[)" + triangles +
                                  R"(],"method":{"fill":"barycentric"}})");
    ASSERT_EQ(groups.size(), 1u);
    EXPECT_EQ(groups[0].kind, CliffKind::sample_on_edge);
    EXPECT_EQ(groups[0].worst.size(), most_cliffs);
    // From O run 51 edges, between the outer vertices 50; all begin or end on samples.
    EXPECT_EQ(groups[0].worst.size() + groups[0].more, 101u);
    EXPECT_EQ(groups[0].worst[0].how_near,
              "passes exactly through 65 samples, one at pixel (0, 0)");
    EXPECT_TRUE(
        std::is_sorted(groups[0].worst.begin(), groups[0].worst.end(),
                       [](const Cliff& a, const Cliff& b) { return a.nearness > b.nearness; }));
}

/// The pixels that differ with a scalar, and out of how many.
std::pair<std::uint64_t, std::uint64_t> compared(const std::string& scalar,
                                                 const std::string& json) {
    for (const ComparedPicture& one : compared_pictures({"scene.json", json}))
        if (one.scalar == scalar)
            return {one.differing, one.pixels};
    throw std::runtime_error("no such scalar: " + scalar);
}

// U lies 1/2^30 before T, which float cannot tell: the first one drawn stays. Whatever their colors.
TEST(ComparedPictures, ShowTheSamePrimitivesToo) {
    const auto planes = [](const std::string& color) {
        return R"({"canvas":{"width":8,"height":8,"origin":"top-left"},"vertices":{"A":[0,0,1],"B":[16,0,1],)"
               R"("C":[0,16,1],"D":[0,0,"1073741823/1073741824"],"E":[16,0,"1073741823/1073741824"],)"
               R"("F":[0,16,"1073741823/1073741824"]},"triangles":["ABC",{"vertices":"DEF","color":")" +
               color + R"("}],"method":{"fill":"top-left","depth":"inverse-z"}})";
    };
    using Counts = std::pair<std::uint64_t, std::uint64_t>;
    for (const std::string color : {"black", "red"}) {
        EXPECT_EQ(compared("float", planes(color)), Counts(64, 64)) << color;
        EXPECT_EQ(compared("double", planes(color)), Counts(0, 64)) << color;
    }
}

// C14: `fixed` leaves nothing of a triangle of one pixel: 1 of 1, not "1 of 0".
TEST(ComparedPictures, CountOutOfThePixelsOfEither) {
    EXPECT_EQ(compared("fixed", find_stress_case("C14")->scenes().front().json),
              (std::pair<std::uint64_t, std::uint64_t>(1, 1)));
}

TEST(ComparedPictures, CountWhatDiffersFromExactOrSayWhyThereIsNone) {
    const std::string json = find_stress_case("S3")->scenes().front().json;
    for (const ComparedPicture& one : compared_pictures({"s3.json", json})) {
        EXPECT_EQ(one.refusal, "");
        EXPECT_EQ(one.differing, one.scalar == "double" ? 1u : 0u) << one.scalar;
        EXPECT_EQ(one.first.has_value(), one.scalar == "double");
        if (one.first) {
            EXPECT_EQ(*one.first, (Pixel{0, 10}));
        }
    }
    for (const ComparedPicture& one :
         compared_pictures({"c10.json", find_stress_case("C10")->scenes().front().json}))
        EXPECT_EQ(one.refusal.empty(), one.scalar != "float" && one.scalar != "fixed")
            << one.scalar;
}

} // namespace
} // namespace rastertrace
