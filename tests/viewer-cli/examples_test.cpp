// SPDX-License-Identifier: MIT
// The frames of the examples, as text. The worked triangle and the lines are those of the texts;
// the fans were also drawn by an independent program of a few lines.

#include "load.h"

#include "frame_text.h"

#include <rastertrace/trace/frame.h>

#include <gtest/gtest.h>

#include <string>

namespace rastertrace {
namespace {

/// The last frame of an example, only the grid.
std::string picture(const std::string& name, const MethodOverrides& method = {}) {
    const Trace trace =
        load_trace(std::string(RASTERTRACE_EXAMPLES) + "/" + name + ".json", method);
    EXPECT_TRUE(trace.damage.empty());
    return bare_frame_text(frame_after(trace, trace.size()));
}

TEST(Examples, Points) {
    EXPECT_EQ(picture("t2-lines/points"), "##...\n"
                                          "#....\n"
                                          "....#\n");
}

TEST(Examples, Bresenham) {
    EXPECT_EQ(picture("t2-lines/bresenham"), "........\n"
                                             "....##..\n"
                                             "..##....\n"
                                             "##......\n");
}

TEST(Examples, Naive) {
    EXPECT_EQ(picture("t2-lines/naive"), ".......#\n"
                                         ".....##.\n"
                                         ".##.#...\n"
                                         "#..#....\n");
}

TEST(Examples, Dda) {
    EXPECT_EQ(picture("t2-lines/dda"), "......##\n"
                                       "....##..\n"
                                       "..##....\n"
                                       "##......\n");
}

TEST(Examples, Octants) {
    EXPECT_EQ(picture("t2-lines/octants"), "...#...#...\n"
                                           "...#...#...\n"
                                           "....#.#....\n"
                                           "##..#.#..##\n"
                                           "..##.#.##..\n"
                                           "....###....\n"
                                           "..##.#.##..\n"
                                           "##..#.#..##\n"
                                           "....#.#....\n"
                                           "...#...#...\n"
                                           "...#...#...\n");
}

TEST(Examples, OutlineOnFill) {
    EXPECT_EQ(picture("t2-lines/outline"), ".................\n"
                                           ".................\n"
                                           "..........#......\n"
                                           ".........##......\n"
                                           "........####.....\n"
                                           ".......#####.....\n"
                                           ".......######....\n"
                                           "......#######....\n"
                                           ".....########....\n"
                                           "....##########...\n"
                                           "....##########...\n"
                                           ".................\n"
                                           ".................\n"
                                           ".................\n");
}

TEST(Examples, TwoHalves) {
    EXPECT_EQ(picture("t3-sweep-and-box/two-halves"), ".....#.......\n"
                                                      "....###......\n"
                                                      "....####.....\n"
                                                      "...######....\n"
                                                      "...#######...\n"
                                                      "..#########..\n"
                                                      "..##########.\n"
                                                      ".#######.....\n"
                                                      ".####........\n"
                                                      ".#...........\n"
                                                      ".............\n");
}

TEST(Examples, Barycentric) {
    EXPECT_EQ(picture("t3-sweep-and-box/barycentric"), ".................\n"
                                                       ".................\n"
                                                       "..........#......\n"
                                                       "..........#......\n"
                                                       ".........##......\n"
                                                       "........####.....\n"
                                                       ".......#####.....\n"
                                                       ".......#####.....\n"
                                                       "......#######....\n"
                                                       ".....########....\n"
                                                       "....##########...\n"
                                                       ".................\n"
                                                       ".................\n"
                                                       ".................\n");
}

TEST(Examples, TopLeft) {
    EXPECT_EQ(picture("t3-sweep-and-box/top-left"), "..........\n"
                                                    ".########.\n"
                                                    ".########.\n"
                                                    ".########.\n"
                                                    ".########.\n"
                                                    ".########.\n"
                                                    ".########.\n"
                                                    ".########.\n"
                                                    ".########.\n"
                                                    "..........\n");
}

TEST(Examples, Fan) {
    EXPECT_EQ(picture("t4-fan/fan"), ".........................\n"
                                     ".############............\n"
                                     "..#######################\n"
                                     "....####################.\n"
                                     ".....###################.\n"
                                     ".......################..\n"
                                     "........###########.##...\n"
                                     "..........###########....\n"
                                     "...........#.#####.##....\n"
                                     "............########.....\n"
                                     "..............#.###......\n"
                                     "...............##.#......\n"
                                     ".................#.......\n");
}

TEST(Examples, FanOfTheFirstTriangle) {
    EXPECT_EQ(picture("t4-fan/first-triangle"), ".................\n"
                                                ".................\n"
                                                "..........#......\n"
                                                ".........##......\n"
                                                "........#.##.....\n"
                                                "........####.....\n"
                                                ".......#.###.....\n"
                                                "......#######....\n"
                                                ".....########....\n"
                                                ".....#########...\n"
                                                "....##########...\n"
                                                ".................\n"
                                                ".................\n"
                                                ".................\n");
}

TEST(Examples, TopLeftHasNoHolesWhereTheFanHas) {
    EXPECT_EQ(picture("t4-fan/fan", {{"fill", "top-left"}}), ".........................\n"
                                                             "..##########.............\n"
                                                             "...#####################.\n"
                                                             ".....##################..\n"
                                                             "......################...\n"
                                                             "........##############...\n"
                                                             ".........############....\n"
                                                             "..........##########.....\n"
                                                             "............#######......\n"
                                                             ".............######......\n"
                                                             "...............###.......\n"
                                                             "................#........\n"
                                                             ".........................\n");
}

} // namespace
} // namespace rastertrace
