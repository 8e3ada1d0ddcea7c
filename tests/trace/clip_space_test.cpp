// SPDX-License-Identifier: MIT
// Vertices that are typed in clip space. What a triangle covers is worked out a second time in homogeneous
// coordinates, without a plane that cuts anything: a pixel's place (X, Y, 1) is a sum of the vertices' (x, y, w), and
// lies in the triangle if no vertex has a part below 0 (Olano and Greer 1997).

#include "random_choice.h"
#include "traces.h"

#include <rastertrace/trace/audit/redo.h>
#include <rastertrace/trace/record/replay.h>
#include <rastertrace/trace/record/traced_steps.h>

#include <fmt/core.h>
#include <gtest/gtest.h>

#include <array>
#include <map>
#include <string>
#include <utility>
#include <vector>

namespace rastertrace {
namespace {

constexpr int width = 12;
constexpr int height = 10;

using Place = std::array<int, 4>;
using Corners = std::array<Place, 3>;

std::string scene_of(const Corners& corners, const std::string& method) {
    std::string vertices;
    for (std::size_t i = 0; i < 3; ++i)
        vertices += fmt::format(R"({}"{}":[{},{},{},{}])", i == 0 ? "" : ",", "ABC"[i],
                                corners[i][0], corners[i][1], corners[i][2], corners[i][3]);
    return fmt::format(
        R"({{"canvas":{{"width":{},"height":{},"origin":"top-left"}},"vertices":{{{}}},)"
        R"("viewport":{{"pixels":"edges","y":"down"}},"triangles":["ABC"],"keep":["depth"],"method":{{{}}}}})",
        width, height, vertices, method);
}

Rational determinant(const std::array<std::array<Rational, 3>, 3>& m) {
    return m[0][0] * (m[1][1] * m[2][2] - m[1][2] * m[2][1]) -
           m[0][1] * (m[1][0] * m[2][2] - m[1][2] * m[2][0]) +
           m[0][2] * (m[1][0] * m[2][1] - m[1][1] * m[2][0]);
}

/// z of a triangle at a pixel, and whether that is inside of it, outside, or neither for certain: on an edge.
struct AtPixel {
    int side = 0; ///< 1: inside, -1: outside
    Rational z = {};
};

AtPixel triangle_at(const Corners& corners, int x, int y) {
    const std::array<Rational, 3> place{Rational(2 * x) / width - 1, Rational(2 * y) / height - 1,
                                        1};
    std::array<std::array<Rational, 3>, 3> rows;
    for (std::size_t i = 0; i < 3; ++i)
        rows[i] = {corners[i][0], corners[i][1], corners[i][3]};
    const Rational whole = determinant(rows);
    if (whole == 0)
        return {};
    AtPixel result{.side = 1};
    const auto keep = [&result](int sign) { result.side = std::min(result.side, sign); };
    for (std::size_t i = 0; i < 3; ++i) {
        auto with_place = rows;
        with_place[i] = place;
        const Rational part = determinant(with_place) / whole;
        keep(sgn(part));
        result.z += part * corners[i][2];
    }
    keep(sgn(Rational(1 - result.z)));
    keep(sgn(Rational(1 + result.z)));
    return result;
}

Corners random_corners(Random& random) {
    Corners corners;
    for (Place& place : corners)
        do
            place = {random.whole(-6, 6), random.whole(-6, 6), random.whole(-6, 6),
                     random.chance(3) ? random.whole(-4, 1) : random.whole(1, 6)};
        while (place == Place{});
    return corners;
}

TEST(ClipSpace, DrawsWhatHomogeneousCoordinatesSay) {
    Random random(40);
    int inside = 0;
    int outside = 0;
    int behind = 0;
    for (int run = 0; run < 400; ++run) {
        const Corners corners = random_corners(random);
        const Trace trace = trace_of(scene_in(scene_of(
            corners,
            R"("fill":"barycentric","scalar":"exact","depth":"ndc-z","depth_compare":"less")")));
        std::map<std::pair<Index, Index>, std::vector<Rational>> depths;
        for (std::size_t n = 1; n <= trace.size(); ++n)
            if (trace.kind_of(n) == StepKind::depth) {
                const auto step = trace.step(n).as<DepthStep>();
                depths[{step.x, step.y}].push_back(*step.depth.exact());
            }
        for (int y = 0; y < height; ++y)
            for (int x = 0; x < width; ++x) {
                const AtPixel there = triangle_at(corners, x, y);
                const auto& told = depths[{x, y}];
                EXPECT_TRUE(there.side >= 0 || told.empty()) << run << ": " << x << ", " << y;
                EXPECT_TRUE(there.side <= 0 || !told.empty()) << run << ": " << x << ", " << y;
                for (const Rational& depth : told)
                    EXPECT_TRUE(there.side == 0 || depth == there.z)
                        << run << ": " << x << ", " << y << ": " << depth;
                inside += there.side > 0 ? 1 : 0;
                outside += there.side < 0 ? 1 : 0;
            }
        behind += std::any_of(corners.begin(), corners.end(),
                              [](const Place& place) { return place[3] < 0; })
                      ? 1
                      : 0;
    }
    EXPECT_GT(inside, 1000);
    EXPECT_GT(outside, 1000);
    EXPECT_GT(behind, 100);
}

TEST(ClipSpace, IsDoneAgainInEveryScalarAndAdaptiveIsExact) {
    Random random(41);
    for (int run = 0; run < 60; ++run) {
        const Corners corners = random_corners(random);
        const std::string fill = random.pick({"scanline", "top-left", "barycentric"});
        std::map<std::string, std::vector<Color>> pictures;
        for (const std::string scalar : {"float", "double", "fixed", "adaptive", "exact"}) {
            const Trace trace = trace_of(scene_in(
                scene_of(corners, fmt::format(R"("fill":"{}","scalar":"{}")", fill, scalar))));
            const Redone redone = redo(trace);
            EXPECT_EQ(redone.wrong, 0U) << run << scalar << redone.first.what;
            const auto colors = frame_after(trace, trace.size()).image.colors();
            pictures[scalar] = {colors.begin(), colors.end()};
        }
        EXPECT_TRUE(pictures["adaptive"] == pictures["exact"]) << run;
    }
}

/// A multiple of all coordinates is the same place: the least and the largest numbers draw what 1 draws.
TEST(ClipSpace, IsTheSameForAnyMultiple) {
    const auto picture = [](const std::string& by) {
        const Trace trace = trace_of(scene_in(
            fmt::format(R"({{"canvas":{{"width":12,"height":10}},"vertices":{{"A":[0,"1{0}",0,)"
                        R"("1{0}"],"B":["-1{0}","-1{0}",0,"2{0}"],"C":["3{0}","-2{0}",0,"3{0}"]}},)"
                        R"("triangles":["ABC"],"method":{{"scalar":"exact"}}}})",
                        by)));
        const auto colors = frame_after(trace, trace.size()).image.colors();
        return std::vector<Color>(colors.begin(), colors.end());
    };
    const auto plain = picture("");
    EXPECT_TRUE(picture("e-250") == plain);
    EXPECT_TRUE(picture("e250") == plain);
}

/// However near to 0 a w is, exact numbers can divide by it.
TEST(ClipSpace, ExactNumbersHaveNoLeastW) {
    for (const std::string scalar : {"exact", "adaptive"})
        for (const std::string w : {"1", "1e-307", "1e-309", "5e-324"}) {
            const Trace trace = trace_of(scene_in(fmt::format(
                R"({{"canvas":{{"width":16,"height":16,"origin":"top-left"}},)"
                R"("viewport":{{"pixels":"edges"}},"vertices":{{"A":["-{0}","-{0}",0,"{0}"],)"
                R"("B":[1,-1,0,1],"C":[0,1,0,1]}},"triangles":["ABC"],)"
                R"("method":{{"scalar":"{1}","fill":"top-left","sample":"center"}}}})",
                w, scalar)));
            EXPECT_EQ(frame_after(trace, trace.size()).image.drawn(), 128U) << scalar << w;
        }
}

/// The line from a place to its opposite leads through (0, 0, 0, 0), where every plane cuts it: it is one place on
/// the screen.
TEST(ClipSpace, ALineToTheOppositePlaceIsAPoint) {
    for (const std::string scalar : {"float", "double", "adaptive", "exact"}) {
        const Trace trace = trace_of(scene_in(
            R"({"canvas":{"width":9,"height":9},"vertices":{"A":[0,0,0,1],"B":[0,0,0,-3]},)"
            R"("lines":["AB"],"method":{"scalar":")" +
            scalar + "\"}}"));
        std::size_t pixels = 0;
        for (std::size_t n = 1; n <= trace.size(); ++n)
            pixels += trace.kind_of(n) == StepKind::pixel ? 1 : 0;
        EXPECT_EQ(pixels, 1U) << scalar;
    }
}

TEST(ClipSpace, RefusesWhatNeedsTheWorld) {
    const auto refusal = [](const std::string& more, const std::string& a = "[0,0,0,1]") {
        return refusal_of_scene(R"({"canvas":{"width":9,"height":9},"vertices":{"A":)" + a +
                                R"(,"B":[1,0,0,2],"C":[0,1,0,2]},"triangles":["ABC"])" + more +
                                "}");
    };
    EXPECT_EQ(refusal(""), "");
    EXPECT_EQ(refusal(R"(,"projection":{"type":"clip-space"})"), "");
    EXPECT_EQ(refusal(R"(,"projection":{"type":"clip-space"})", "[0,0]"), "");
    EXPECT_EQ(refusal(R"(,"projection":{"type":"pinhole","distance":1})"),
              "expected no projection beside vertices [x, y, z, w], found one: they are in clip "
              "space already");
    EXPECT_EQ(refusal("", "[0,0]"), "expected vertices that all have a w, or none; found both");
    EXPECT_EQ(refusal("", "[0,0,0,0]"),
              "expected a vertex in clip space, found (0, 0, 0, 0), which is no place");
    for (const auto& [key, value] :
         std::map<std::string, std::string>{{"camera", R"({"position":[0,0,4]})"},
                                            {"light", R"({"direction":[0,0,4]})"},
                                            {"model", R"([{"scale":[2,2,2]}])"}})
        EXPECT_EQ(refusal(",\"" + key + "\":" + value),
                  "expected no " + key +
                      " beside vertices in clip space, found one: where they are in the world is "
                      "not known");
    EXPECT_EQ(refusal(R"(,"method":{"cull":"back"})"),
              "expected no cull beside vertices in clip space, found one: where they are in the "
              "world is not known");
    EXPECT_EQ(refusal_of_scene(R"({"vertices":{"A":[0,0,0,1]},"points":["A"]})"),
              "expected a canvas with a width and a height beside a vertex of four numbers, in "
              "clip space, "
              "found none");
}

} // namespace
} // namespace rastertrace
