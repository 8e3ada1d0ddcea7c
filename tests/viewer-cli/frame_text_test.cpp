// SPDX-License-Identifier: MIT
#include "frames/frame_text.h"
#include "picture.h"
#include "traces.h"

#include <rastertrace/trace/tell/describe.h>

#include <gtest/gtest.h>

#include <string>

namespace rastertrace {
namespace {

/// The frame of steps `first` to `last`.
std::string frame(const Trace& trace, std::size_t first, std::size_t last, TextSize size = {}) {
    Replay replay(trace);
    replay.go_to(first);
    const FrameText about{describe_step(replay), first, last};
    replay.go_to(last);
    return frame_text(replay, about, size);
}

/// Its rows of pixels.
std::string grid_of(const std::string& frame) {
    const std::size_t labels = frame.find("\n\n") + 2;
    return frame.substr(frame.find('\n', labels) + 1);
}

TEST(FrameText, OfARowOfTheFirstTriangle) {
    Scene scene = first_triangle();
    scene.title = "First triangle";
    EXPECT_EQ(frame(trace_of(scene), 14, 19),
              "First triangle                                             steps 14 to 19 of 62\n"
              "scanline y=2   left AB: x = 2 + 3/4 (2 - 5) = -1/4 -> floor -> -1   right AC: x = 2 "
              "- 3/8 (2 - 5) "
              "= 25/8 -> floor -> 3\n"
              "\n"
              "     -8-7-6-5-4-3-2-1 0 1 2 3 4 5 6 7 8\n"
              "  7   . . . . . . . . . . . . . . . . .\n"
              "  6   . . . . . . . . . . . . . . . . .\n"
              "  5   . . . . . . . . . . A . . . . . .\n"
              "  4   . . . . . . . . . # # . . . . . .\n"
              "  3   . . . . . . . . # # # . . . . . .\n"
              "> 2   . . . . . . . @ @ @ @ @ . . . . .\n"
              "  1   . . . . . . . . . . . . . . . . .\n"
              "  0   . . . . . . . . . . . . . . . . .\n"
              " -1   . . . . . . . . . . . . . . . . .\n"
              " -2   . . . . . . . . . . . . . . . . .\n"
              " -3   . . . . b . . . . . . . . c . . .\n"
              " -4   . . . . . . . . . . . . . . . . .\n"
              " -5   . . . . . . . . . . . . . . . . .\n"
              " -6   . . . . . . . . . . . . . . . . .\n");
}

TEST(FrameText, MarksWhatItsStepIsAbout) {
    const Trace polygon = trace_of(scene_in(
        R"({"canvas":{"width":9,"height":4,"origin":"bottom-left"},"polygons":["ABCD"],
            "vertices":{"A":[1,0],"B":[7,0],"C":[7,3],"D":[1,3]},"method":{"scalar":"exact"}})"));
    // The ends of its edge.
    EXPECT_EQ(grid_of(frame(polygon, 3, 3)), "  3   . d . . . . .[c].\n"
                                             "  2   . . . . . . . . .\n"
                                             "  1   . . . . . . . . .\n"
                                             "  0   . a . . . . .[b].\n");
    // The rows of a half, and the pixel that a decision is made at.
    const Trace halves = trace_of(scene_in(
        R"({"canvas":{"width":9,"height":4,"origin":"bottom-left"},"triangles":["ABC"],
            "vertices":{"A":[1,0],"B":[7,1],"C":[1,3]},"method":{"fill":"two-halves"}})"));
    EXPECT_EQ(grid_of(frame(halves, 5, 5)), "  3   . c . . . . . . .\n"
                                            "  2   . . . . . . . . .\n"
                                            "> 1   . . . . . . . b .\n"
                                            "> 0   . a . . . . . . .\n");
    const Trace line = trace_of(scene_in(
        R"({"canvas":{"width":9,"height":3,"origin":"bottom-left"},"lines":["AB"],
            "vertices":{"A":[0,0],"B":[5,2]}})"));
    EXPECT_EQ(grid_of(frame(line, 5, 5)), "  2   . . . . . b . . .\n"
                                          "  1   . . . . . . . . .\n"
                                          "> 0   A[#]. . . . . . .\n");
}

TEST(FrameText, WideCanvasDropsTheGapsAndThinsTheLabels) {
    const Trace trace =
        trace_of(triangle_scene({"0", "0", "59", "0", "0", "2"},
                                {.width = 60, .height = 3, .origin = Origin::top_left}, {}));
    EXPECT_EQ(frame(trace, 1, 1),
              "A triangle                                                         step 1 of " +
                  std::to_string(trace.size()) +
                  "\n"
                  "triangle ABC   A (0, 0)   B (59, 0)   C (0, 2)\n"
                  "\n"
                  "     0    5   10   15   20   25   30   35   40   45   50   55\n"
                  "  0  a..........................................................b\n"
                  "  1  ............................................................\n"
                  "  2  c...........................................................\n");
}

TEST(FrameText, LargeCanvasIsAWindowAroundTheNewestPixel) {
    const Trace trace =
        trace_of(triangle_scene({"500", "300", "500", "300", "500", "300"},
                                {.width = 1000, .height = 1000, .origin = Origin::top_left}, {}));
    const std::string text = frame(trace, trace.size(), trace.size(), {.columns = 27, .lines = 17});
    EXPECT_EQ(text.substr(text.find('\n') + 1),
              "pixel (500, 300)   row\n"
              "y=300: 500 to 500\n"
              "(x 490 to 510, y 296 to 303 of a canvas of 1000 x 1000)\n"
              "\n"
              "    490  495  500  505  510\n"
              " 296  .....................\n"
              " 297  .....................\n"
              " 298  .....................\n"
              " 299  .....................\n"
              ">300  ..........@..........\n"
              " 301  .....................\n"
              " 302  .....................\n"
              " 303  .....................\n");
}

TEST(FrameText, TitleIsCutAndMadeSafe) {
    Scene scene = first_triangle();
    scene.title = "\x1b]0;x\x07" + std::string(1'000'000, 'y');
    const std::string text = frame(trace_of(scene), 1, 1);
    EXPECT_EQ(text.substr(0, text.find('\n')),
              "<U+001B>]0;x<U+0007>" + std::string(42, 'y') + "...  step 1 of 62");
}

TEST(FrameText, Bare) {
    const Trace trace = trace_of(first_triangle());
    EXPECT_EQ(bare_frame_text(frame_after(trace, 62)), textbook_picture);
}

/// The grid of a triangle, without title and sentence.
std::string grid(FrameText about, TextSize size = {}) {
    const Trace trace = trace_of(scene_in(R"({"canvas":{"width":5,"height":4,"origin":"top-left"},
        "vertices":{"A":[0,0],"B":[3,0],"C":[0,3]},"triangles":["ABC"]})"));
    Replay replay(trace, {.writes = true});
    replay.go_to(trace.size());
    about.first_step = about.last_step = trace.size();
    about.has_heading = false;
    return frame_text(replay, about, size);
}

TEST(FrameText, MarksTheCursor) {
    EXPECT_EQ(grid({.view = View::plotted, .cursor = Pixel{1, 1}}), "\n"
                                                                    "      0 1 2 3 4\n"
                                                                    "  0   A # # B .\n"
                                                                    "  1   #(#)# . .\n"
                                                                    "  2   # # . . .\n"
                                                                    "> 3   @ . . . .\n");
    // Without gaps it is another sign.
    EXPECT_EQ(grid({.view = View::plotted, .cursor = Pixel{1, 1}}, {10, 20}), "\n"
                                                                              "     0 2 4\n"
                                                                              "  0  A##B.\n"
                                                                              "  1  #+#..\n"
                                                                              "  2  ##...\n"
                                                                              "> 3  @....\n");
}

TEST(FrameText, OfLargeCellsFillsThemWithSignsAndCentersTheRest) {
    EXPECT_EQ(grid({.view = View::plotted, .cursor = Pixel{4, 3}, .scale = 2}),
              "\n"
              "        0   1   2   3   4\n"
              "  0   AAA ### ### BBB    \n"
              "      AAA ### ### BBB  . \n"
              "  1   ### ### ###        \n"
              "      ### ### ###  .   . \n"
              "  2   ### ###            \n"
              "      ### ###  .   .   . \n"
              "> 3   @@@            (   )\n"
              "      @@@  .   .   . ( . )\n");
}

TEST(FrameText, OfHalfBlocksHasTwoPixelsInACharacter) {
    const std::string text = grid({.view = View::shade,
                                   .colors = ColorDepth::truecolor,
                                   .cursor = Pixel{3, 1},
                                   .has_half_blocks = true});
    const std::string black = "\x1b[38;2;0;0;0m▀\x1b[0m";
    const std::string both = "\x1b[38;2;0;0;0;48;2;0;0;0m▀\x1b[0m";
    EXPECT_EQ(
        text,
        "\n     0 2 4\n  0  " + both + both + both +
            "\x1b[38;2;0;0;0;48;2;255;255;0m▀\x1b[0m·  A x=0  B x=3\n" // the cursor below a black one
            "> 2  \x1b[38;2;0;0;0;48;2;255;0;255m▀\x1b[0m" +           // the last step's pixel
            black +
            "···  C x=0\n\ndark -~:+=*o%8& light\n");
}

} // namespace
} // namespace rastertrace
