// SPDX-License-Identifier: MIT
// What is printed of a scene is a sheet: every sentence of every step is read as a claim, and is right.

#include "claims_support.h"
#include "effort.h"
#include "random_scene.h"
#include "traces.h"

#include <rastertrace/trace/check/check.h>
#include <rastertrace/trace/tell/describe.h>

#include <fmt/core.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <map>
#include <string>
#include <string_view>

namespace rastertrace {
namespace {

/// The sentences of a trace, a line each: all, or as many as a test has time for.
std::string sentences_of(const Trace& trace) {
    constexpr std::size_t most_steps = 400;
    std::string text;
    Replay replay(trace, FrameParts{.depths = true});
    for (std::size_t n = 1; n <= std::min(trace.size(), most_steps); ++n) {
        replay.go_to(n);
        text += describe_step(replay) + "\n";
    }
    return text;
}

/// The kinds of steps that claims of a file are about, each with how many.
void count_kinds(const Claims& claims, std::map<std::string, std::size_t>& kinds) {
    for (const Claim& claim : claims.claims)
        ++kinds[claim.step];
}

TEST(Sentences, WhatIsToldOfAnySceneIsRight) {
    const std::size_t wanted = random_cases(300U);
    std::map<std::string, std::size_t> kinds;
    std::size_t count = 0;
    for (std::uint64_t seed = 1; count < wanted; ++seed) {
        const std::string scene = RandomScene(seed).text();
        const auto read = read_scene({"scene.json", scene});
        if (!read)
            continue;
        ++count;
        const std::string text = sentences_of(trace_of(read.value().scene));
        const Claims claims = claims_in(text);
        Checked checked;
        try {
            checked = check(Truth({"scene.json", scene}, {}), claims);
        } catch (const Problem& problem) {
            ADD_FAILURE() << to_text(problem) << scene;
        }
        for (const CheckedClaim& claim : checked.claims)
            ASSERT_EQ(claim.verdict, ClaimVerdict::right) << claims.claims[claim.claim].text << "\n"
                                                          << scene;
        count_kinds(claims, kinds);
    }
    for (const std::string_view kind : {"vertex", "primitive", "face", "light", "edge", "scanline",
                                        "along", "decide", "sample", "depth", "pixel", "matrix"})
        EXPECT_GE(kinds[std::string(kind)], random_cases(20U)) << kind;
}

/// T0's triangle.
const std::string triangle = R"({"canvas":{"width":17,"height":14},
 "vertices":{"A":[2,5],"B":[-4,-3],"C":[5,-3]},"triangles":["ABC"],"method":{"scalar":"exact"}})";

TEST(Sentences, ANumberThatIsChangedIsWrong) {
    const std::string sentence =
        "scanline y=2   left AB: x = 2 + 3/4 (2 - 5) = {} -> floor -> {}   "
        "right AC: x = 2 - 3/8 (2 - 5) = {} -> floor -> {}\n";
    const auto wrong_fields = [&](const auto&... numbers) {
        const Checked checked =
            check_claims(triangle, fmt::format(fmt::runtime(sentence), numbers...));
        std::string fields;
        for (const CheckedField& field : checked.claims.at(0).fields)
            if (field.verdict != ClaimVerdict::right)
                fields += field.name + " ";
        return fields;
    };
    EXPECT_EQ(wrong_fields("-1/4", -1, "25/8", 3), "");
    EXPECT_EQ(wrong_fields("1/4", -1, "25/8", 3), "left ");
    EXPECT_EQ(wrong_fields("-1/4", 0, "25/8", 3), "from ");
    EXPECT_EQ(wrong_fields("-1/4", -1, "3.1", 3), "");
    EXPECT_EQ(wrong_fields("-1/4", -1, "24/8", 4), "right to ");
}

TEST(Sentences, AFrameIsReadAroundItsPicture) {
    const Claims claims = claims_in("First triangle                       steps 14 to 19 of 62\n"
                                    "scanline y=2   left AB: x = 2 + 3/4 (2 - 5) = -1/4 -> floor\n"
                                    "-> -1   right AC: x = 2 - 3/8 (2 - 5) = 25/8 -> floor -> 3\n"
                                    "    left AB: x = (x2 - x1)/(y2 - y1) (y - y1) + x1 = -1/4\n"
                                    "\n"
                                    "     -2-1 0 1\n"
                                    "  3   . . # .\n"
                                    "> 2   . . . @\n"
                                    "\n"
                                    "a ABC  b ACD  x tested, not drawn\n"
                                    "22 rows lie above the canvas\n"
                                    "\n"
                                    "stages: depth\n"
                                    "\n"
                                    "y=1: -1, 7/2\n");
    ASSERT_EQ(claims.claims.size(), 2U);
    EXPECT_EQ(claims.not_judged, 5U); // the picture's rows, a working, a remark
    const Checked checked = check(Truth({"scene.json", triangle}, {}), claims);
    EXPECT_EQ(checked.right, 2U);
    EXPECT_EQ(checked.claims[0].fields.size(), 6U); // with the names of both edges
}

TEST(Sentences, ATableOfStepsIsReadBelowItsTitle) {
    const Claims claims =
        claims_in("First triangle\n"
                  "\n"
                  "   3  edge AB: dx/dy = (-4 - 2) / (-3 - 5) = 3/4; x = 2 + 3/4 (y - 5)\n"
                  "          dx = -4 - 2 = -6, dy = -3 - 5 = -8\n"
                  "   5  pixel (2, 5)   row y=5: 2 to 2\n");
    ASSERT_EQ(claims.claims.size(), 2U);
    EXPECT_EQ(claims.not_judged, 1U);
    EXPECT_EQ(check(Truth({"scene.json", triangle}, {}), claims).right, 2U);
}

/// Of two steps that a sentence could be, it is the one that says so.
TEST(Sentences, WithoutTheirPrimitiveTheyAreRightIfOneIs) {
    const std::string lines = R"({"canvas":{"width":8,"height":8,"origin":"bottom-left"},
 "vertices":{"A":[0,0],"B":[5,2],"C":[3,5]},"lines":["AB","AC"]})";
    const auto verdict = [&](int d) {
        const auto text = fmt::format("at (0, 0): d = {} <= 0, straight on to E; d + 4 = 3\n", d);
        return check_claims(lines, text).claims.at(0).verdict;
    };
    EXPECT_EQ(verdict(-1), ClaimVerdict::right);
    EXPECT_EQ(verdict(-2), ClaimVerdict::wrong);
}

} // namespace
} // namespace rastertrace
