// SPDX-License-Identifier: MIT
// What a scene is about, in a few lines.

#include "picture.h"
#include "traces.h"

#include <rastertrace/trace/record/step_kind.h>
#include <rastertrace/trace/tell/digest.h>
#include <rastertrace/trace/text/input.h>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <string>

namespace rastertrace {
namespace {

using testing::ElementsAre;
using testing::EndsWith;
using testing::HasSubstr;
using testing::StartsWith;

Trace trace_of_file(const std::string& file) {
    const auto scene = read_scene(read_source(file).value());
    return readable_trace(trace_text(scene.value(), {}));
}

Trace trace_of_example(const std::string& name) {
    return trace_of_file(RASTERTRACE_EXAMPLES "/" + name + ".json");
}

TEST(Digest, TheRowsOfATriangle) {
    const auto lines = digest_of(trace_of(first_triangle()));
    ASSERT_EQ(lines.size(), 10U);
    EXPECT_EQ(lines[0], "triangle ABC   A (2, 5)   B (-4, -3)   C (5, -3)");
    EXPECT_EQ(lines[4], "  y=2    AB x = -1/4 -> -1    AC x = 25/8 -> 3   5 pixels");
    EXPECT_EQ(lines[9], "  y=-3   AB x = -4 -> -4      AC x = 5 -> 5      10 pixels");
}

TEST(Digest, TheSlopeAndTheDecisionsOfALine) {
    // 2 dy - dx = 4 - 5, 2 dy = 4, 2 (dy - dx) = -6
    EXPECT_THAT(digest_of(trace_of_example("t2-lines/bresenham")),
                ElementsAre("line AB   A (0, 0)   B (5, 2)   octant 1   m = 2/5   "
                            "d = -1, then + 4 or - 6"));
    EXPECT_THAT(digest_of(trace_of_example("t2-lines/naive")).front(), EndsWith("m = 1/2"));
    // With a mistake, what it decides by: d = 0 in the place of 2 (5) - 7.
    const std::string file = RASTERTRACE_EXAMPLES "/tutorial/mistakes/d-from-zero.jsonl";
    EXPECT_THAT(digest_of(readable_trace(read_source(file).value().text)).front(),
                EndsWith("d = 0, then + 10 or - 4"));
    // Where y is the longer direction, x is a function of it: (0, 0) to (2, 5).
    EXPECT_THAT(digest_of(trace_of_example("t2-lines/octants"))[1], HasSubstr("1/m = 2/5"));
}

TEST(Digest, WhatBecameOfTheFacesOfACube) {
    const auto lines = digest_of(trace_of_example("t0-hidden/cube-culled"));
    ASSERT_EQ(lines.size(), 12U);
    EXPECT_EQ(lines[1], "ACD   normal (0, 0, -4)   . to eye = 12: drawn     depth 1/3   "
                        "28 of 36 depth tests pass");
    EXPECT_EQ(std::ranges::count_if(
                  lines, [](const std::string& line) { return line.ends_with(": culled"); }),
              10);
}

TEST(Digest, AVertexOnItsWayToTheScreen) {
    const auto lines = digest_of(trace_of_example("t4-pipeline/six-spaces"));
    ASSERT_EQ(lines.size(), 7U);
    EXPECT_EQ(lines[0], "vertex A in object space: (1, 1, 1)");
    EXPECT_THAT(lines[5], StartsWith("vertex A in screen space: (20, 10/3)"));
    EXPECT_EQ(lines[6], "... and 18 more: --every vertex");
}

TEST(Digest, OfEveryExampleAFewLines) {
    for (const std::string& name : example_files()) {
        const Trace trace = trace_of_file(name);
        const auto lines = digest_of(trace);
        EXPECT_LE(lines.size(), 12U) << name;
        EXPECT_EQ(lines.empty(), trace.lacks(StepKind::primitive) && trace.lacks(StepKind::vertex))
            << name;
        const auto fewer = digest_of(trace, 3);
        EXPECT_LE(fewer.size(), 3U) << name;
        if (lines.size() > 3) {
            EXPECT_THAT(fewer.back(), StartsWith("... and ")) << name;
        }
    }
}

} // namespace
} // namespace rastertrace
