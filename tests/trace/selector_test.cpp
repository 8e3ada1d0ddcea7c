// SPDX-License-Identifier: MIT
// Which steps a text means, and what is said of a text that means none.

#include "picture.h"
#include "told_problem.h"
#include "traces.h"

#include <rastertrace/trace/tell/selector.h>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <string>
#include <vector>

namespace rastertrace {
namespace {

using testing::ElementsAre;

using Steps = std::vector<std::size_t>;

/// The steps that a text means, or nothing but a failure.
Steps steps_of(const std::string& text, const Trace& trace) {
    const auto selector = parse_selector({"--every", text}, trace);
    if (!selector) {
        ADD_FAILURE() << to_text(selector.problem());
        return {};
    }
    const auto steps = matching_steps(selector.value(), trace);
    if (!steps) {
        ADD_FAILURE() << to_text(steps.problem());
        return {};
    }
    return steps.value();
}

/// What is wrong with a text that ought to mean one step.
std::string complaint(const std::string& text, const Trace& trace) {
    const auto selector = parse_selector({"--step", text}, trace);
    if (!selector)
        return to_text(selector.problem());
    const auto step = matching_step(selector.value(), trace, "say which");
    return step ? "" : to_text(step.problem());
}

/// A square that is hidden by another one but for its left column, and a face seen from behind.
Trace hidden_square() {
    return trace_of(scene_in(R"({"canvas":{"width":4,"height":1,"origin":"top-left"},
        "vertices":{"A":[1,0,1],"B":[3,0,1],"C":[3,1,1],"D":[0,0,2],"E":[2,0,2],"F":[2,1,2]},
        "triangles":["ABC","DEF",{"vertices":"ACB","name":"other side"}],
        "method":{"depth":"linear-z","cull":"back"}})"));
}

TEST(Selector, MeansStepsOfTheFirstTriangle) {
    const Trace trace = trace_of(first_triangle());
    const std::vector<std::pair<std::string, Steps>> table{
        {"14", {14}},
        {"0", {0}},
        {"first", {1}},
        {"last", {62}},
        {" last ", {62}},
        {"edge", {2, 3, 4}},
        {"scanline", {5, 7, 10, 14, 20, 26, 33, 42, 52}},
        {"scanline y=2", {14}},
        {"scanline y=2.0", {14}},
        {"  scanline   y=-3\t", {52}},
        {"scanline left=-1/4", {14}},
        {"scanline left=-0.25", {14}},
        {"scanline right=25/8", {14}},
        {"scanline right=3.125", {14}},
        {"scanline from=-1 to=3", {14, 20}},
        {"scanline left_edge=AB right_edge=AC y=2", {14}},
        {"edge edge=BC", {3}},
        {"edge edge=\"BC\"", {3}},
        {"edge dx_dy=null", {3}},
        {"pixel x=2 y=2", {18}},
        {"pixel 2,2", {18}},
        {"pixel -1,1 in=ABC", steps_of("pixel x=-1 y=1", trace)},
        {"scanline 2", {14}},
        {"edge BC", {3}},
        {"edge CB", {3}}, // by either name
        {"edge edge=CB", {3}},
        {"scanline left_edge=BA y=2", {14}},
        {"pixel in=ABC x=2 y=2", {18}},
        {"primitive vertices=[A,B,C]", {1}},
        {"primitive at=[[2,5],[-4,-3],[5,-3]]", {1}},
    };
    for (const auto& [text, steps] : table)
        EXPECT_EQ(steps_of(text, trace), steps) << text;
}

TEST(Selector, HasWordsForWhatWasDecided) {
    const Trace trace = hidden_square();
    const auto said = [&trace](const std::string& text) {
        std::string all;
        for (const std::size_t n : steps_of(text, trace))
            all += std::string(trace.step(n).json()) + "\n";
        return all;
    };
    EXPECT_EQ(said("depth pass in=DEF"),
              "{\"step\":\"depth\",\"x\":0,\"y\":0,\"depth\":2,\"stored\":null,\"pass\":true}\n");
    EXPECT_EQ(steps_of("depth fail", trace).size(), 2u);
    EXPECT_EQ(steps_of("depth pass=false", trace), steps_of("depth fail", trace));
    EXPECT_EQ(steps_of("depth fail in=DEF", trace), steps_of("depth fail", trace));
    EXPECT_EQ(steps_of("face drawn", trace).size(), 2u);
    EXPECT_EQ(steps_of("face culled", trace), steps_of("face in=\"other side\"", trace));

    const Trace weighed = trace_of(first_triangle({.fill = Fill::barycentric}));
    EXPECT_EQ(steps_of("sample inside", weighed).size(), steps_of("pixel", weighed).size());
    EXPECT_EQ(steps_of("sample inside", weighed).size() +
                  steps_of("sample outside", weighed).size(),
              steps_of("sample", weighed).size());
}

TEST(Selector, MeansThePartsOfAPrimitiveToo) {
    const Trace trace = trace_of(scene_in(R"({"canvas":{"width":8,"height":8},
        "vertices":{"A":[0,1,1],"B":[-1,-1,-3],"C":[1,-1,-3]},"triangles":["ABC"],
        "projection":{"type":"frustum","fov_y":90,"near":1,"far":9}})"));
    EXPECT_EQ(steps_of("primitive name=ABC/1", trace).size(), 1u);
    EXPECT_EQ(steps_of("pixel in=ABC", trace), steps_of("pixel", trace));
    EXPECT_LT(steps_of("pixel in=ABC/1", trace).size(), steps_of("pixel", trace).size());
}

TEST(Selector, TakesKindsAndFieldsOfAForeignRasterizer) {
    const Trace trace = readable_trace(R"({"rastertrace":1,"canvas":{"width":2,"height":2},"steps":[
{"step":"fetch","unit":2,"texel":"1/2","list":[1, 2]},
{"step":"pixel","x":0,"y":0,"shader":"phong"},
{"step":"pixel","x":1,"y":0,"shader":"flat"}
],"end":{"steps":3}})");
    EXPECT_THAT(steps_of("fetch", trace), ElementsAre(1));
    EXPECT_THAT(steps_of("fetch unit=2", trace), ElementsAre(1));
    EXPECT_THAT(steps_of("fetch texel=0.5", trace), ElementsAre(1));
    EXPECT_THAT(steps_of("fetch list=[1,2]", trace), ElementsAre(1));
    EXPECT_THAT(steps_of("pixel shader=flat", trace), ElementsAre(3));
}

TEST(Selector, SaysWhatIsWrongWithAText) {
    const Trace trace = trace_of(first_triangle());
    struct Fault {
        std::string text;
        std::size_t column;
        std::string message, hint = {};
    };
    const std::vector<Fault> faults{
        {" ", 2,
         "--step: expected a step (N, first, last, or KIND field=value ...), found nothing"},
        {"63", 1, "--step: expected a step from 0 to 62, found 63"},
        {"-1", 1, "--step: expected a step from 0 to 62, found -1"},
        {"1x", 1, "--step: expected a step from 0 to 62, found 1x"},
        {"last pixel", 6, "--step: expected nothing behind last, found more"},
        {"skanline y=2", 1,
         "--step: expected a kind of step that the trace has (primitive, edge, scanline, pixel), "
         "found skanline",
         "did you mean scanline?"},
        {"depth fail", 1,
         "--step: expected a kind of step that the trace has (primitive, edge, scanline, pixel), "
         "found depth"},
        {"scanline z=2", 10,
         "--step: expected a field of scanline (y, left, right, from, to, left_edge, right_edge, "
         "left_depth, right_depth, in), found z"},
        {"scanline lef=2", 10,
         "--step: expected a field of scanline (y, left, right, from, to, left_edge, right_edge, "
         "left_depth, right_depth, in), found lef",
         "did you mean left?"},
        {"scanline y=two", 10, "--step: expected a whole number for y, found two"},
        {"scanline y=1/2", 10, "--step: expected a whole number for y, found 1/2"},
        {"scanline left=AB", 10,
         "--step: expected a number, like 3.125 or 25/8, for left, found AB"},
        {"primitive part=1", 11, "--step: expected true or false for part, found 1"},
        {"primitive at=2", 11, "--step: expected a list, like [1,2], for at, found 2"},
        {"scanline y=", 10, "--step: expected y=VALUE, found no value"},
        {"scanline two", 10, "--step: expected a whole number for y, found two"},
        {"pixel 2", 7, "--step: expected field=value or X,Y, found 2"},
        {"pixel 2,b", 7, "--step: expected a whole number for y, found b"},
        {"edge edge=\"BC", 11, "--step: expected a closing quote, found none"},
        {"scanline y=9", 10, "--step: expected a step of the trace, found none with y=9",
         "scanline has y: 5, 4, 3, 2, 1, ..."},
        {"pixel x=3 y=3", 11, "--step: expected a step of the trace, found none with y=3",
         "pixel x=3 has y: 2, 1, 0, -1, -2, ..."},
        {"scanline left=0", 10, "--step: expected a step of the trace, found none with left=0",
         "scanline has left: -1/4, 1/2, -1, 5/4, -7/4, ..."},
        {"edge CD", 6, "--step: expected a step of the trace, found none with edge=CD",
         "edge has edge: AB, BC, AC"},
        {"pixel color=red", 7, "--step: expected a step of the trace, found none with color=red",
         "no pixel has color"},
        {"scanline", 1, "--step: expected one step, found 9: 5, 7, 10, 14, 20, ...", "say which"}};
    for (const auto& [text, column, message, hint] : faults)
        EXPECT_EQ(complaint(text, trace), message + quoted_at(column, text, hint));

    EXPECT_EQ(complaint("depth y=0 failed", hidden_square()),
              "--step: expected field=value or X,Y or pass or fail, found failed\n"
              "depth y=0 failed\n"
              "          ^\n"
              "hint: did you mean fail?");
}

} // namespace
} // namespace rastertrace
