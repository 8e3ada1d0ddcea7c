// SPDX-License-Identifier: MIT
// What a trace tells of a midpoint circle. The numbers are those of Hearn and Baker's example, radius 10.

#include "claims_support.h"
#include "traces.h"

#include <rastertrace/trace/audit/redo.h>
#include <rastertrace/trace/audit/stats.h>
#include <rastertrace/trace/check/check.h>
#include <rastertrace/trace/explain/explain.h>
#include <rastertrace/trace/record/replay.h>
#include <rastertrace/trace/record/traced_steps.h>
#include <rastertrace/trace/tell/describe.h>
#include <rastertrace/trace/tell/working.h>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <string>
#include <vector>

namespace rastertrace {
namespace {

using ::testing::Contains;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;

std::string scene_text(const std::string& circle = R"("center":"O","radius":10,"name":"k")",
                       const std::string& more = "") {
    return R"({"canvas":{"width":31,"height":31},"vertices":{"O":[2,-1]},"circles":[{)" + circle +
           "}]" + more + "}";
}

std::vector<std::string> sentences_of(const Trace& trace, StepKind kind) {
    std::vector<std::string> sentences;
    Replay replay(trace);
    for (std::size_t n = 1; n <= trace.size(); ++n) {
        replay.go_to(n);
        if (trace.kind_of(n) == kind)
            sentences.push_back(describe_step(replay));
    }
    return sentences;
}

TEST(CircleTrace, TellsEachDecision) {
    const Trace trace = trace_of(scene_in(scene_text()));
    EXPECT_EQ(trace.step(1).json(),
              R"({"step":"primitive","kind":"circle","name":"k","vertices":["O"],"at":[[2,-1]],)"
              R"("color":"#000000","radius":10})");
    EXPECT_THAT(sentences_of(trace, StepKind::primitive),
                ElementsAre("circle k   O (2, -1)   radius 10"));
    EXPECT_THAT(sentences_of(trace, StepKind::decide),
                ElementsAre("at (2, 9): d = -9 < 0, straight on to E; d + 3 = -6",
                            "at (3, 9): d = -6 < 0, straight on to E; d + 5 = -1",
                            "at (4, 9): d = -1 < 0, straight on to E; d + 7 = 6",
                            "at (5, 9): d = 6 >= 0, diagonally to SE; d - 9 = -3",
                            "at (6, 8): d = -3 < 0, straight on to E; d + 11 = 8",
                            "at (7, 8): d = 8 >= 0, diagonally to SE; d - 3 = 5",
                            "at (8, 7): d = 5 >= 0, diagonally to SE; d + 1 = 6"));
    EXPECT_THAT(sentences_of(trace, StepKind::pixel),
                Contains("pixel (-2, -10)   d = 6 >= 0, diagonally"));
}

/// A decision is about pixels in all octants.
TEST(CircleTrace, OfARegionHasAllDecisions) {
    const Scene scene = scene_in(scene_text());
    const Trace trace =
        sound_trace(trace_text(scene, {.filter = {.region = Region{2, -11, 12, -1}}}));
    EXPECT_EQ(sentences_of(trace, StepKind::decide),
              sentences_of(trace_of(scene), StepKind::decide));
    EXPECT_THAT(sentences_of(trace, StepKind::pixel),
                Contains("pixel (6, -10)   d = 6 >= 0, diagonally"));
}

TEST(CircleTrace, HasAWorking) {
    const Trace trace = trace_of(scene_in(scene_text()));
    Replay replay(trace);
    for (std::size_t n = 1; n <= trace.size(); ++n)
        if (trace.kind_of(n) == StepKind::decide && trace.step(n).as<DecideStep>().x == 5)
            replay.go_to(n);
    EXPECT_THAT(working_of(replay),
                ElementsAre("x = 3, y = 10 from the center: d = (x + 1)^2 + y^2 - y - r^2 = 4^2 + "
                            "10^2 - 10 - 10^2 = 6",
                            "the midpoint (4, 10 - 1/2) lies outside the circle",
                            "E adds 2 x + 3 = 9, SE 2 (x - y) + 5 = -9", "next d = 6 - 9 = -3"));
}

TEST(CircleTrace, EachDecisionIsDoneAgain) {
    for (const std::string scalar : {"float", "double", "fixed", "adaptive", "exact"}) {
        const std::string text =
            trace_text(scene_in(R"({"vertices":{"O":["7/3","-1/2"]},"circles":)"
                                R"([{"center":"O","radius":33}],"method":{)"
                                R"("scalar":")" +
                                scalar + R"("}})"));
        const Redone right = redo(sound_trace(text));
        EXPECT_EQ(right.wrong, 0U) << scalar;
        EXPECT_EQ(right.count.at("decide: d"), right.count.at("decide: move"));
        EXPECT_GE(right.count.at("decide: d"), 20U);
    }
    const auto replaced = [](const std::string& from, const std::string& to) {
        std::string text = trace_text(scene_in(scene_text()));
        text.replace(text.find(from), from.size(), to);
        return redo(readable_trace(text));
    };
    EXPECT_EQ(replaced(R"("d":-9,)", R"("d":-8,)").first.what, "decide: d");
    EXPECT_EQ(replaced(R"("d":-9,"move":"E")", R"("d":-9,"move":"SE")").first.what, "decide: move");
}

TEST(CircleTrace, ClaimsAboutItsDecisionsAreChecked) {
    const auto field_of = [](const std::string& claim) {
        return check_claims(scene_text(), claim).claims.at(0).fields.at(0);
    };
    EXPECT_EQ(field_of("k: -9 -6 -1 6 -3 8 5\n").verdict, ClaimVerdict::right);
    const CheckedField wrong = field_of("k: -9 -6 -1 6 -4 8 5\n");
    EXPECT_EQ(wrong.verdict, ClaimVerdict::wrong);
    EXPECT_EQ(wrong.place, 5U);
    EXPECT_EQ(wrong.expected, "-3");
}

TEST(CircleTrace, ExplainsAndCountsPixels) {
    const Trace trace = trace_of(scene_in(scene_text()));
    const auto why_not = [&trace](int x, int y) {
        const auto answer = explain(trace, {.about = Topic::pixel, .pixel = {x, y}});
        return answer && answer.value().why_not.size() == 1
                   ? answer.value().why_not.front().sentence
                   : "";
    };
    EXPECT_EQ(why_not(7, 4),
              "it lies 10 from (2, -1), and the square of the pixel's distance is 50: inside");
    EXPECT_EQ(why_not(12, 0 + 9),
              "it lies 10 from (2, -1), and the square of the pixel's distance is 200: outside");
    const Stats stats = stats_of(trace);
    ASSERT_EQ(stats.primitives.size(), 1U);
    EXPECT_EQ(stats.primitives[0].kind, "circle");
    EXPECT_EQ(stats.primitives[0].writes, 56U);
    EXPECT_EQ(stats.primitives[0].over, 0U);
    EXPECT_THAT(stats.unjudged, IsEmpty());
}

TEST(CircleScene, FitsOnItsCanvas) {
    const Scene scene =
        scene_in(R"({"vertices":{"O":[2,-1]},"circles":[{"center":"O","radius":10}]})");
    EXPECT_EQ(scene.canvas.width, 2 * 13 + 1);
    EXPECT_EQ(scene.canvas.height, 2 * 12 + 1);
    EXPECT_EQ(scene.primitives[0].name, "O");
}

TEST(CircleScene, IsRefusedWithAReason) {
    for (const std::string radius : {"2.5", "-1", "16385", "\"5\"", "null"})
        EXPECT_THAT(refusal_of_scene(scene_text(R"("center":"O","radius":)" + radius)),
                    HasSubstr("expected a whole number of pixels from 0 to 16384, found "))
            << radius;
    EXPECT_EQ(refusal_of_scene(scene_text(R"("center":"O","radius":16384)")), "");
    EXPECT_EQ(refusal_of_scene(scene_text(R"("radius":1)")),
              "expected the key \"center\", found none");
    EXPECT_EQ(refusal_of_scene(scene_text(R"("center":"Q","radius":1)")),
              "expected the name of a vertex, found \"Q\"");
    EXPECT_EQ(refusal_of_scene(R"({"vertices":{"O":[2,-1]},"circles":["O"]})"),
              R"(expected a circle, like {"center": "A", "radius": 5}, found "O")");
    EXPECT_EQ(refusal_of_scene(
                  scene_text(R"("center":"O","radius":1)", R"(,"method":{"depth":"linear-z"})")),
              "expected no depth buffer beside a circle, found one");
}

} // namespace
} // namespace rastertrace
