// SPDX-License-Identifier: MIT
#include "frame_text.h"
#include "picture.h"
#include "traces.h"

#include <rastertrace/trace/describe.h>

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

} // namespace
} // namespace rastertrace
