// SPDX-License-Identifier: MIT
// Viewports of other programs in whole scenes: where vertices come to, and what their depths become.

#include "traces.h"

#include <rastertrace/trace/audit/redo.h>
#include <rastertrace/trace/record/replay.h>
#include <rastertrace/trace/record/traced_steps.h>

#include <gtest/gtest.h>

#include <map>
#include <string>
#include <vector>

namespace rastertrace {
namespace {

/// Two triangles that cross, seen from (0, 0, 4).
std::string scene_with(const std::string& viewport, const std::string& method) {
    return R"({"canvas":{"width":24,"height":16,"origin":"top-left"},"camera":{"position":[0,0,4]},)"
           R"("projection":{"type":"frustum","fov_y":60,"near":1,"far":9},)"
           R"("vertices":{"A":[-2,-1,1],"B":[2,-1,-2],"C":[0,2,0],"D":[-2,1,-2],"E":[2,1,1],"F":[0,-2,0]},)"
           R"("triangles":["ABC",{"vertices":"DEF","color":"#ff0000"}],)" +
           (viewport.empty() ? "" : R"("viewport":)" + viewport + ",") + R"("method":{)" + method +
           "}}";
}

Trace drawn(const std::string& viewport, const std::string& method) {
    return sound_trace(trace_text(scene_in(scene_with(viewport, method))));
}

/// The depths that primitives have at their vertices, and z of the same vertices after division by w.
struct Depths {
    std::vector<Rational> depths;
    std::vector<Rational> canonical;
};

Depths depths_in(const Trace& trace) {
    Depths found;
    std::map<std::string, Rational> z;
    for (std::size_t n = 1; n <= trace.size(); ++n) {
        const StepView step = trace.step(n);
        if (trace.kind_of(n) == StepKind::vertex && step.as<VertexStep>().space == Space::canonical)
            z[step.as<VertexStep>().name.text()] = *step.as<VertexStep>().at.values()[2].exact();
        if (trace.kind_of(n) != StepKind::primitive)
            continue;
        const auto primitive = step.as<PrimitiveStep>();
        for (const auto& depth : primitive.depths.values())
            found.depths.push_back(*depth.exact());
        for (const std::string& name : primitive.vertices.texts())
            found.canonical.push_back(z.at(name));
    }
    return found;
}

std::vector<Color> picture_in(const Trace& trace) {
    const Frame frame = frame_after(trace, trace.size());
    const auto colors = frame.image.colors();
    return {colors.begin(), colors.end()};
}

TEST(DepthRange, IsWhereTheNearestAndTheFarthestGo) {
    struct Case {
        std::string range;
        Rational near, far;
    };
    const auto without = picture_in(drawn("", R"("depth":"ndc-z","scalar":"exact")"));
    for (const Case& one : {Case{"[0,1]", 0, 1}, Case{"[1,0]", 1, 0}, Case{"[-1,1]", -1, 1},
                            Case{R"(["1/4","-3/4"])", Rational(1, 4), Rational(-3, 4)}}) {
        const Trace trace =
            drawn(R"({"pixels":"centers","depth_range":)" + one.range + "}", R"("scalar":"exact")");
        const Depths found = depths_in(trace);
        ASSERT_EQ(found.depths.size(), 6U);
        for (std::size_t i = 0; i < found.depths.size(); ++i)
            EXPECT_EQ(found.depths[i],
                      one.near + (found.canonical[i] + 1) * (one.far - one.near) / 2)
                << one.range;
        // Nearer stays nearer, whichever way depths grow.
        EXPECT_TRUE(picture_in(trace) == without) << one.range;
    }
}

TEST(DepthRange, IsDoneAgainInEveryScalar) {
    for (const std::string scalar : {"float", "double", "fixed", "adaptive", "exact"})
        for (const std::string range : {"[0,1]", "[1,0]"}) {
            const Trace trace =
                drawn(R"({"pixels":"edges","y":"down","depth_range":)" + range + "}",
                      R"("fill":"top-left","scalar":")" + scalar + "\"");
            const Redone redone = redo(trace);
            EXPECT_EQ(redone.wrong, 0U) << scalar << ' ' << range << redone.first.what;
            EXPECT_GT(redone.count.size(), 0U);
        }
}

/// What UIUC CS418 says of its rasterizer, (x/w + 1) W/2 and (y/w + 1) H/2, typed as a scene.
TEST(ViewportOfEdges, TakesCanonicalCoordinatesToPixels) {
    const Trace trace = sound_trace(trace_text(scene_in(
        R"({"canvas":{"width":20,"height":30,"origin":"top-left"},"viewport":)"
        R"({"pixels":"edges","y":"down"},"vertices":{"A":[-0.5,0.5],"B":[1,-1],"C":[0,0.2]},)"
        R"("triangles":["ABC"],"method":{"scalar":"exact"}})")));
    std::vector<std::string> places;
    for (std::size_t n = 1; n <= trace.size(); ++n)
        if (trace.kind_of(n) == StepKind::primitive)
            for (const auto& corner : trace.step(n).as<PrimitiveStep>().at.values())
                for (const auto& number : corner.values())
                    places.push_back(number.exact()->get_str());
    EXPECT_EQ(places, (std::vector<std::string>{"5", "45/2", "20", "0", "10", "18"}));
}

} // namespace
} // namespace rastertrace
