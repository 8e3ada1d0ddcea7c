// SPDX-License-Identifier: MIT
// Tests of the rasterizer beside, by its trace. Run in the folder that has mine.jsonl.

#include <rastertrace/testing.h>

#include <gtest/gtest.h>

using namespace rastertrace::matchers;
using ::testing::Not;

TEST(Rasterizer, DrawsTheFirstTriangle) {
    EXPECT_THAT(trace_in("mine.jsonl"), ShowsPicture(".................\n"
                                                     ".................\n"
                                                     "..........#......\n"
                                                     ".........##......\n"
                                                     "........###......\n"
                                                     ".......#####.....\n"
                                                     ".......#####.....\n"
                                                     "......######.....\n"
                                                     ".....########....\n"
                                                     "....#########....\n"
                                                     "....##########...\n"
                                                     ".................\n"
                                                     ".................\n"
                                                     ".................\n"));
}

TEST(Rasterizer, RoundsBothEndsOfARowDown) {
    const TestedTrace mine = trace_in("mine.jsonl");
    EXPECT_THAT(mine, HasScanline(2, "-1/4", "25/8"));
    EXPECT_THAT(mine, PlotsPixel(-1, 2));
    EXPECT_THAT(mine, Not(PlotsPixel(4, 2)));
}
