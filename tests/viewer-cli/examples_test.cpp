// SPDX-License-Identifier: MIT
// The frames of the examples, as text. The worked triangle and the lines are those of the texts;
// the fans were also drawn by an independent program of a few lines.

#include "app/load.h"

#include "frames/frame_text.h"
#include "picture.h"

#include <rastertrace/testing.h>
#include <rastertrace/trace/audit/stats.h>
#include <rastertrace/trace/record/replay.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

namespace rastertrace {
namespace {

using matchers::ShowsPicture;

/// An example, drawn by its own method.
matchers::TestedTrace example(const std::string& name) {
    return matchers::trace_in(std::string(RASTERTRACE_EXAMPLES) + "/" + name + ".json");
}

/// The last frame of an example, only the grid.
std::string picture(const std::string& name, const MethodOverrides& method = {}) {
    const Trace trace =
        load_trace(std::string(RASTERTRACE_EXAMPLES) + "/" + name + ".json", {.method = method});
    EXPECT_TRUE(trace.damage.empty());
    return bare_frame_text(frame_after(trace, trace.size()));
}

/// The last frame of an example, each pixel as the letter of the primitive that is seen there: a for
/// the first of the trace, and so on.
std::string owners(const std::string& name, const MethodOverrides& method = {}) {
    const Trace trace =
        load_trace(std::string(RASTERTRACE_EXAMPLES) + "/" + name + ".json", {.method = method});
    const Frame frame = frame_after(trace, trace.size());
    std::vector<std::size_t> begins;
    for (std::size_t n = 1; n <= trace.size(); ++n)
        if (trace.kind_of(n) == StepKind::primitive)
            begins.push_back(n);
    std::string text;
    for (std::size_t i = 0; i < frame.drawn_by.size(); ++i) {
        const auto after = std::upper_bound(begins.begin(), begins.end(), frame.drawn_by[i]);
        text +=
            frame.drawn_by[i] == 0 ? '.' : static_cast<char>('a' + (after - begins.begin() - 1));
        if ((i + 1) % static_cast<std::size_t>(trace.canvas.width) == 0)
            text += '\n';
    }
    return text;
}

TEST(Examples, Points) {
    EXPECT_THAT(example("t2-lines/points"), ShowsPicture("##...\n"
                                                         "#....\n"
                                                         "....#\n"));
}

TEST(Examples, BresenhamNaiveAndDda) {
    EXPECT_EQ(side_by_side({picture("t2-lines/bresenham"), picture("t2-lines/naive"),
                            picture("t2-lines/dda")}),
              "........  .......#  ......##\n"
              "....##..  .....##.  ....##..\n"
              "..##....  .##.#...  ..##....\n"
              "##......  #..#....  ##......\n");
}

TEST(Examples, Octants) {
    EXPECT_THAT(example("t2-lines/octants"), ShowsPicture("...#...#...\n"
                                                          "...#...#...\n"
                                                          "....#.#....\n"
                                                          "##..#.#..##\n"
                                                          "..##.#.##..\n"
                                                          "....###....\n"
                                                          "..##.#.##..\n"
                                                          "##..#.#..##\n"
                                                          "....#.#....\n"
                                                          "...#...#...\n"
                                                          "...#...#...\n"));
}

TEST(Examples, FirstTriangleWithItsOutlineByWeightsAndByTheFan) {
    EXPECT_EQ(side_by_side({picture("t2-lines/outline"), picture("t3-sweep-and-box/barycentric"),
                            picture("t4-fan/first-triangle")}),
              ".................  .................  .................\n"
              ".................  .................  .................\n"
              "..........#......  ..........#......  ..........#......\n"
              ".........##......  ..........#......  .........##......\n"
              "........####.....  .........##......  ........#.##.....\n"
              ".......#####.....  ........####.....  ........####.....\n"
              ".......######....  .......#####.....  .......#.###.....\n"
              "......#######....  .......#####.....  ......#######....\n"
              ".....########....  ......#######....  .....########....\n"
              "....##########...  .....########....  .....#########...\n"
              "....##########...  ....##########...  ....##########...\n"
              ".................  .................  .................\n"
              ".................  .................  .................\n"
              ".................  .................  .................\n");
}

TEST(Examples, TwoHalves) {
    EXPECT_THAT(example("t3-sweep-and-box/two-halves"), ShowsPicture(".....#.......\n"
                                                                     "....###......\n"
                                                                     "....####.....\n"
                                                                     "...######....\n"
                                                                     "...#######...\n"
                                                                     "..#########..\n"
                                                                     "..##########.\n"
                                                                     ".#######.....\n"
                                                                     ".####........\n"
                                                                     ".#...........\n"
                                                                     ".............\n"));
}

TEST(Examples, TopLeft) {
    EXPECT_THAT(example("t3-sweep-and-box/top-left"), ShowsPicture("..........\n"
                                                                   ".########.\n"
                                                                   ".########.\n"
                                                                   ".########.\n"
                                                                   ".########.\n"
                                                                   ".########.\n"
                                                                   ".########.\n"
                                                                   ".########.\n"
                                                                   ".########.\n"
                                                                   "..........\n"));
}

TEST(Examples, TopLeftHasNoHolesWhereTheFanHas) {
    EXPECT_EQ(side_by_side({picture("t4-fan/fan"), picture("t4-fan/fan", {{"fill", "top-left"}})}),
              ".........................  .........................\n"
              ".############............  ..##########.............\n"
              "..#######################  ...#####################.\n"
              "....####################.  .....##################..\n"
              ".....###################.  ......################...\n"
              ".......################..  ........##############...\n"
              "........###########.##...  .........############....\n"
              "..........###########....  ..........##########.....\n"
              "...........#.#####.##....  ............#######......\n"
              "............########.....  .............######......\n"
              "..............#.###......  ...............###.......\n"
              "...............##.#......  ................#........\n"
              ".................#.......  .........................\n");
}

// The corners by hand: A (20, 10/3), B (28, 6), C (20, 14), D (100/3, 50/3), each to the nearest
// pixel, joined by Bresenham's lines.
TEST(Examples, SixSpaces) {
    EXPECT_THAT(example("t4-pipeline/six-spaces"),
                ShowsPicture(".........................................\n"
                             ".........................................\n"
                             ".........................................\n"
                             "....................##...................\n"
                             "....................#####................\n"
                             "....................#.#.###..............\n"
                             "....................#..#...##............\n"
                             "....................#...#..##............\n"
                             "....................#....##..#...........\n"
                             "....................#....##..#...........\n"
                             "....................#...#.##..#..........\n"
                             "....................#..#...#..#..........\n"
                             "....................#.#.....#..#.........\n"
                             "....................##.......#.#.........\n"
                             "....................###.......#.#........\n"
                             ".......................####....##........\n"
                             "...........................####.##.......\n"
                             "...............................###.......\n"
                             ".........................................\n"
                             ".........................................\n"
                             ".........................................\n"));
}

// Cut at the near plane, where w = 1, the triangle is a quadrilateral: by hand (16, 4), (8, 12),
// (8, 16) and (20, 4).
TEST(Examples, BehindTheEye) {
    EXPECT_THAT(example("t4-pipeline/behind-the-eye"),
                ShowsPicture(".................................\n"
                             ".................................\n"
                             ".................................\n"
                             ".................................\n"
                             "...............####..............\n"
                             "..............####...............\n"
                             ".............####................\n"
                             "............####.................\n"
                             "...........####..................\n"
                             "..........####...................\n"
                             ".........####....................\n"
                             "........####.....................\n"
                             "........###......................\n"
                             "........##.......................\n"
                             "........#........................\n"
                             ".................................\n"
                             ".................................\n"));
}

// The front face from (-4, 3) to (3, -4), the back one from (-2, 2) to (2, -2), as floors; the text's
// figure cuts toward zero.
TEST(Examples, CubeOfT0) {
    EXPECT_EQ(side_by_side({picture("t0-projection/cube"),
                            picture("t0-projection/cube", {{"snap", "truncate"}})}),
              "..........  ..........\n"
              "..........  ..........\n"
              ".########.  ..#######.\n"
              ".#######..  ..######..\n"
              ".#######..  ..######..\n"
              ".#####.#..  ..####.#..\n"
              ".####..#..  ..###..#..\n"
              ".#######..  ..######..\n"
              ".##.....#.  ..#.....#.\n"
              ".#......#.  ..........\n");
}

// The front face alone, as its two triangles; their diagonal goes to the one drawn first. In the order
// of the list, what is drawn last stays: the back face (k, l) and the sides. The painter draws the front
// face last; its diagonal goes to the triangle drawn last.
TEST(Examples, CubeCulledWithDepthInDrawOrderAndByThePainter) {
    EXPECT_EQ(side_by_side({owners("t0-hidden/cube-culled"), owners("t0-hidden/cube-inverse-z"),
                            owners("t0-hidden/cube-draw-order"), owners("t0-hidden/cube-painter")}),
              "..........  ..........  ..........  ..........\n"
              "..........  ..........  ..........  ..........\n"
              ".aaaaaaaa.  .aaaaaaaa.  .hhhhhhhh.  .lkkkkkkk.\n"
              ".baaaaaaa.  .baaaaaaa.  .cclllllf.  .llkkkkkk.\n"
              ".bbaaaaaa.  .bbaaaaaa.  .cdkllllf.  .lllkkkkk.\n"
              ".bbbaaaaa.  .bbbaaaaa.  .cdkklllf.  .llllkkkk.\n"
              ".bbbbaaaa.  .bbbbaaaa.  .cdkkkllf.  .lllllkkk.\n"
              ".bbbbbaaa.  .bbbbbaaa.  .ddkkkklf.  .llllllkk.\n"
              ".bbbbbbaa.  .bbbbbbaa.  .djjjiiif.  .lllllllk.\n"
              ".bbbbbbba.  .bbbbbbba.  .jiiiiiii.  .llllllll.\n");
}

// T1's walk. Faces 1 to 3 are 5 x 5 and meet nobody; 4 and 5 are 7 x 5, less twice 2 x 2 that a nearer
// face has; 6, 7 and 8 cover whatever is there.
TEST(Examples, EightFaces) {
    const Trace trace =
        load_trace(std::string(RASTERTRACE_EXAMPLES) + "/t1-hidden/eight-faces.json", {});
    const Stats stats = stats_of(trace);
    std::vector<std::uint64_t> writes; // of the two halves of a square face
    for (std::size_t i = 0; i < 16; i += 2)
        writes.push_back(stats.primitives[i].writes + stats.primitives[i + 1].writes);
    EXPECT_EQ(writes, (std::vector<std::uint64_t>{25, 25, 25, 27, 27, 33, 55, 240}));
    EXPECT_EQ(owners("t1-hidden/eight-faces"), "pooooooooooooooooooooooo\n"
                                               "ppppoooooooooooooooooooo\n"
                                               "ppppppoooooooooooooooooo\n"
                                               "ppppppppoooooooooooooooo\n"
                                               "pppppppppppooooooooooooo\n"
                                               "pppppppppppppooooooooooo\n"
                                               "ppppppppppppppppoooooooo\n"
                                               "ppppppppppppppppppoooooo\n"
                                               "ppppppppppppppppppppoooo\n"
                                               "pppppppppppppppppppppppo\n");
}

// A solid like a U on its side: culling keeps the near wall (a, b) and the inside of the far one
// (i, j) with its floor (g, h); drawn later, the far one covers the near one.
TEST(Examples, ConcaveSolidNeedsDepth) {
    EXPECT_EQ(side_by_side({owners("t3-light/concave-culled"), owners("t3-light/concave-depth")}),
              ".................  .................\n"
              "aaaaaaaaaaaaaaab.  aaaaaaaaaaaaaaaa.\n"
              "aaaiiiiiiiijjabb.  aaaaaaaaaaaaaaab.\n"
              "aaaiiiiiiijjjbbb.  aaaaaaaaaaaaaabb.\n"
              "aaaiiiiiijjjjbbb.  aaaaaaaaaaaaabbb.\n"
              "aaaiiiiijjjjjbbb.  aaaaaaaaaaaabbbb.\n"
              "aaaiiiijjjjjjbbb.  aaaaaaaaaaabbbbb.\n"
              "aaaiiijjjjjjjbbb.  aaaaaaaaaabbbbbb.\n"
              "aaaiijjjjjjjjbbb.  aaaaaaaaabbbbbbb.\n"
              "aaaijjjjjjjjjbbb.  aaaaaaaabbbbbbbb.\n"
              "aaajjjjjjjjjjbbb.  aaaaaaabbbbbbbbb.\n"
              "aaghhhhhhhhhhhhb.  aaaaaabbbbbbbbbb.\n"
              "aaaabbbbbbbbbbbb.  aaaaabbbbbbbbbbb.\n"
              "aaabbbbbbbbbbbbb.  aaaabbbbbbbbbbbb.\n"
              "aabbbbbbbbbbbbbb.  aaabbbbbbbbbbbbb.\n"
              "abbbbbbbbbbbbbbb.  aabbbbbbbbbbbbbb.\n"
              ".................  .................\n");
}

// numerics.md Z10 and Z2, as scenes.
TEST(Examples, CycleAndSteepTriangle) {
    const auto seen = [](const std::string& name, char letter, const MethodOverrides& method = {}) {
        const std::string text = owners(name, method);
        return std::count(text.begin(), text.end(), letter);
    };
    const std::string cycle = "t0-hidden/painters-cycle";
    EXPECT_EQ(4096 - seen(cycle, '.'), 817);
    EXPECT_NE(owners(cycle), owners(cycle, {{"depth", "inverse-z"}}));
    EXPECT_EQ(seen("t0-hidden/steep-triangle", 'a'), 1971);
    EXPECT_EQ(seen("t0-hidden/steep-triangle", 'a', {{"depth", "linear-z"}}), 1236);
}

// A sphere seen by the eye is whole; culled by a light from behind it, faces are missing and the
// inside shows.
TEST(Examples, CulledByLight) {
    EXPECT_NE(picture("t3-light/lambert"), picture("t3-light/culled-by-light"));
    const std::string whole = picture("t3-light/lambert");
    const std::string part = picture("t3-light/culled-by-light");
    EXPECT_LT(std::count(part.begin(), part.end(), '#'),
              std::count(whole.begin(), whole.end(), '#'));
}

// The scenes that the report of error against run time is shown on.
TEST(Examples, NumericsScenes) {
    const auto writes = [](const std::string& scene, const std::string& primitive,
                           const MethodOverrides& method) {
        const Stats stats = stats_of(load_trace(
            std::string(RASTERTRACE_EXAMPLES) + "/numerics/" + scene, {.method = method}));
        for (const PrimitiveStats& one : stats.primitives)
            if (one.name == primitive)
                return one.writes;
        throw std::runtime_error("no such primitive: " + primitive);
    };
    // The worked triangle, five times as large: its area is 900 and 60 points of the grid lie on its
    // sides, so that by Pick it has 900 + 60/2 + 1 points in all.
    EXPECT_EQ(writes("friendly.json", "worked triangle", {{"rounding", "inside"}}), 931u);
    // The two triangles that share the slope 1/3 have all pixels of the canvas, each once, but for
    // its top row, whose centers lie half a pixel above them.
    const MethodOverrides each_once{{"fill", "top-left"}, {"depth", "none"}};
    EXPECT_EQ(writes("stiff.json", "to the horizon", each_once) +
                  writes("stiff.json", "from the horizon", each_once),
              128u * 383u);
    // A speck round one pixel's center; a sliver and half a square pixel that miss all of them.
    EXPECT_EQ(writes("extreme.json", "a speck", {{"depth", "none"}}), 1u);
    EXPECT_EQ(writes("extreme.json", "area one half", {{"depth", "none"}}), 0u);
    EXPECT_EQ(writes("extreme.json", "a sliver on the samples", {{"depth", "none"}}), 0u);
}

TEST(Examples, AnArrowOfEars) {
    EXPECT_THAT(example("faces/arrow"), ShowsPicture(".................\n"
                                                     ".................\n"
                                                     "........#........\n"
                                                     "........##.......\n"
                                                     "........###......\n"
                                                     ".############....\n"
                                                     ".#############...\n"
                                                     ".#############...\n"
                                                     ".############....\n"
                                                     "........###......\n"
                                                     "........##.......\n"
                                                     "........#........\n"));
}

} // namespace
} // namespace rastertrace
