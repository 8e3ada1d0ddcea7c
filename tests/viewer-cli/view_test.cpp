// SPDX-License-Identifier: MIT
// What the cells of a frame show in each view. The traces are written by hand.
#include "app/load.h"
#include "frames/frame_text.h"
#include "traces.h"
#include <rastertrace/trace/tell/view.h>

#include <gtest/gtest.h>

#include <filesystem>
#include <map>
#include <string>
#include <utility>

namespace rastertrace {
namespace {

/// A trace of these steps on a canvas of 5 x 2 pixels, y down.
Trace trace_in(const std::string& steps, const std::string& depth = "none") {
    return readable_trace(R"({"rastertrace":1,"title":"By hand",
"canvas":{"width":5,"height":2,"origin":"top-left"},"method":{"depth":")" +
                          depth + R"("},"steps":[)" + steps + "]}");
}

std::string primitive(const std::string& name, const std::string& color = "#000000",
                      const std::string& more = "") {
    return R"({"step":"primitive","kind":"triangle","name":")" + name +
           R"(","vertices":["A","B","C"],"at":[[0,0],["22/5",0],[0,1]],"color":")" + color + '"' +
           more + "}";
}
std::string pixel(int x, int y, const std::string& more = "") {
    return R"(,{"step":"pixel","x":)" + std::to_string(x) + R"(,"y":)" + std::to_string(y) + more +
           "}";
}
std::string depth_test(int x, const std::string& depth, const std::string& stored, bool passes) {
    return R"(,{"step":"depth","x":)" + std::to_string(x) + R"(,"y":0,"depth":)" + depth +
           R"(,"stored":)" + stored + R"(,"pass":)" + (passes ? "true" : "false") + "}";
}

/// The grid after the last step.
std::string grid(const Trace& trace, View view) {
    Replay replay(trace, parts_for(view, trace));
    replay.go_to(trace.size());
    return bare_frame_text(replay, view);
}

/// All that `show` prints of the last step, or of the steps from one to the last.
std::string shown(const Trace& trace, View view, FrameText about = {}, TextSize size = {}) {
    Replay replay(trace, parts_for(view, trace));
    replay.go_to(trace.size());
    about.caption = "said";
    about.view = view;
    about.last_step = trace.size();
    if (about.first_step == 0)
        about.first_step = trace.size();
    const std::string text = frame_text(replay, about, size);
    return text.substr(text.find("said"));
}

TEST(Views, FacesAreLettersOfWhatIsSeen) {
    // T10, with corners of its own, covers all of A1, and the corner A.
    std::string t10 = primitive("T10");
    t10.replace(t10.find(R"("A","B","C")"), 11, R"("D","E","F")");
    const std::string steps = primitive("A1") + pixel(0, 0) + "," + t10 + pixel(0, 0) +
                              pixel(1, 0) + "," + primitive("T9") + pixel(2, 0) + pixel(2, 1);
    const Trace trace = trace_in(steps);
    EXPECT_EQ(grid(trace, View::faces), "aab..\n"
                                        "..b..\n");
    EXPECT_EQ(shown(trace, View::faces), "said\n"
                                         "\n"
                                         "      0 1 2 3 4\n"
                                         "  0   a a b . .  B x=4\n"
                                         "> 1   . .[b]. .  C x=0\n"
                                         "\n"
                                         "a T10  b T9\n");

    // The painter has changed the scene's order.
    const Trace painted = trace_in(
        R"({"step":"order","names":["A1","T10","T9"],"distances":[3,2,1],"listed":[3,2,1]},)" +
            steps,
        "painter");
    EXPECT_EQ(grid(painted, View::faces), "bba..\n"
                                          "..a..\n");

    // A pixel before any primitive hides nothing, and is of none.
    EXPECT_EQ(
        grid(trace_in(pixel(0, 0).substr(1) + "," + primitive("A1") + pixel(1, 0)), View::faces),
        "#a...\n"
        ".....\n");
}

TEST(Views, AFaceKeepsItsLetterInAllFrames) {
    // A1 is drawn over by T10; in the end T10 and T9 can be seen.
    const Trace trace = trace_in(primitive("A1") + pixel(0, 0) + "," + primitive("T10") +
                                 pixel(0, 0) + pixel(1, 0) + "," + primitive("T9") + pixel(2, 0));
    const auto frame_at = [&](std::size_t n) {
        Replay replay(trace, parts_for(View::faces, trace));
        replay.go_to(n);
        FrameText about{.view = View::faces};
        const std::string text = frame_text(replay, about, {});
        return bare_frame_text(replay, View::faces).substr(0, 5) + text.substr(text.rfind("\n\n"));
    };
    EXPECT_EQ(frame_at(2), "c....\n\nc A1\n");
    EXPECT_EQ(frame_at(4), "a....\n\na T10\n");
    EXPECT_EQ(frame_at(7), "aab..\n\na T10  b T9\n");
}

TEST(Views, WhatIsDrawnOverTakesNoLetterFromWhatIsSeen) {
    // 36 faces over each other and one beside them: two can be seen at the end, and 33 more have letters.
    std::string steps = primitive("first") + pixel(1, 0);
    for (int i = 0; i < 36; ++i)
        steps += "," + primitive("T" + std::to_string(i)) + pixel(0, 0);
    const Trace trace = trace_in(steps);
    const auto cell_at = [&](std::size_t n) {
        Replay replay(trace, parts_for(View::faces, trace));
        replay.go_to(n);
        return bare_frame_text(replay, View::faces).substr(0, 2);
    };
    EXPECT_EQ(cell_at(2), ".a");
    EXPECT_EQ(cell_at(4), "ca");
    EXPECT_EQ(cell_at(2 + 2 * 33), "9a");
    EXPECT_EQ(cell_at(2 + 2 * 34), "#a");
    EXPECT_EQ(cell_at(2 + 2 * 36), "ba");
}

TEST(Views, PartsOfAClippedFaceShareItsLetter) {
    const Trace trace = trace_in(primitive("ABC/1", "#000000", R"(,"part":true)") + pixel(0, 0) +
                                 "," + primitive("ABC/2", "#000000", R"(,"part":true)") +
                                 pixel(1, 0) + "," + primitive("X/Y") + pixel(2, 0));
    EXPECT_EQ(grid(trace, View::faces), "aab..\n.....\n");
}

TEST(Views, ManyFacesAreMeshesOrColors) {
    std::string meshes, colors;
    for (int i = 0; i < 36; ++i) {
        const std::string comma = i == 0 ? "" : ",";
        const std::string name = (i < 20 ? "left.f" : "right.f") + std::to_string(i);
        meshes += comma + primitive(name) + pixel(i % 5, i / 5 % 2);
        colors +=
            comma + primitive(std::to_string(i), i < 34 ? "#112233" : "#445566") + pixel(i % 5, 0);
    }
    // Each pixel is drawn again and again: all 36 have to be seen for that, so 36 rows are needed.
    const auto tall = [](std::string steps, const std::string& y) {
        std::string text = R"({"rastertrace":1,"canvas":{"width":36,"height":1,"origin":"top-left"},
"method":{"depth":"none"},"steps":[)";
        int x = 0;
        for (std::size_t at = steps.find(y); at != std::string::npos; at = steps.find(y, at + 1)) {
            const std::size_t end = steps.find('}', at);
            steps.replace(at, end - at,
                          R"("step":"pixel","x":)" + std::to_string(x++) + R"(,"y":0)");
        }
        return readable_trace(text + steps + "]}");
    };
    const Trace by_mesh = tall(meshes, R"("step":"pixel")");
    EXPECT_EQ(grid(by_mesh, View::faces), std::string(20, 'a') + std::string(16, 'b') + "\n");
    const Trace by_color = tall(colors, R"("step":"pixel")");
    EXPECT_EQ(grid(by_color, View::faces), std::string(34, 'a') + std::string(2, 'b') + "\n");
    EXPECT_NE(shown(by_mesh, View::faces).find("\nmeshes: a left  b right\n"), std::string::npos);
    EXPECT_NE(shown(by_color, View::faces).find("\ncolors: a #112233  b #445566\n"),
              std::string::npos);
}

TEST(Views, ShadeIsARampInWhichBlackIsNotEmpty) {
    const Trace trace =
        trace_in(primitive("ABC", "#000000") + pixel(0, 0) + pixel(1, 0, R"(,"color":"#808080")") +
                 pixel(2, 0, R"(,"color":"#ffffff")"));
    // Half way between the levels of black and white is half way up the ramp.
    EXPECT_EQ(grid(trace, View::shade), "-*&..\n.....\n");
}

TEST(Views, ABackgroundIsSeenInShadeAlone) {
    Trace trace = trace_in(primitive("ABC", "#000000") + pixel(0, 0));
    const std::string plotted = grid(trace, View::plotted);
    const std::string faces = grid(trace, View::faces);
    trace.background = Color{255, 255, 255};
    EXPECT_EQ(grid(trace, View::shade), "-&&&&\n&&&&&\n");
    EXPECT_EQ(grid(trace, View::plotted), plotted);
    EXPECT_EQ(grid(trace, View::faces), faces);
    EXPECT_NE(shown(trace, View::shade).find("background & #ffffff"), std::string::npos);
}

TEST(Views, ADepthThatIsNotFiniteIsShownAsItStands) {
    const Trace trace =
        trace_in(primitive("ABC") + depth_test(1, R"("NaN")", "null", true) + pixel(1, 0));
    EXPECT_EQ(grid(trace, View::depth), "  . NaN   .   .   .\n  .   .   .   .   .\n");
    // Where numbers have no room.
    const std::string narrow = shown(trace, View::depth, {}, {.columns = 12, .lines = 20});
    EXPECT_NE(narrow.find("? not finite\n"), std::string::npos) << narrow;
    EXPECT_NE(narrow.find(".?..."), std::string::npos) << narrow;
}

TEST(Views, DepthIsTheBuffer) {
    // T0, figure 10: infinity, 3, 2.
    const std::string steps = primitive("ABC") + depth_test(1, "3", "null", true) + pixel(1, 0) +
                              depth_test(2, "2", "null", true) + pixel(2, 0) +
                              depth_test(2, R"("5/2")", "2", false);
    EXPECT_EQ(grid(trace_in(steps, "linear-z"), View::depth), "inf   3   2 inf inf\n"
                                                              "inf inf inf inf inf\n");
    // Where numbers do not fit: a ramp, the nearest is the brightest.
    EXPECT_EQ(shown(trace_in(steps, "linear-z"), View::depth, {}, {.columns = 12, .lines = 20}),
              "said\n"
              "\n"
              "     0 2 4\n"
              "> 0  .-x..  A x=0  B x=4\n"
              "  1  .....  C x=0\n"
              "\n"
              "far 3 -~:+=*o%8& 2 near\n"
              "x tested, not drawn\n");
}

TEST(Views, WritesAreCounted) {
    std::string steps = primitive("ABC") + pixel(0, 0);
    for (int i = 0; i < 9; ++i)
        steps += pixel(1, 0);
    for (int i = 0; i < 10; ++i)
        steps += pixel(2, 1);
    EXPECT_EQ(grid(trace_in(steps), View::writes), "19...\n..+..\n");
}

TEST(Views, CoverageIsTheDistanceFromTheNearestEdge) {
    // Corners (0, 0), (22/5, 0), (0, 1); nothing but the samples on the edges lies inside.
    EXPECT_EQ(grid(trace_in(primitive("ABC")), View::coverage), "00000\n"
                                                                "0----\n");
}

TEST(Views, PlottedMarksWhatIsNewAndWhatIsNotDrawn) {
    const Trace trace = trace_in(primitive("ABC") + pixel(0, 0) + pixel(1, 0) + pixel(2, 0) +
                                 depth_test(3, "1", "1", false));
    FrameText about;
    about.first_step = 3;
    EXPECT_EQ(shown(trace, View::plotted, about), "said\n"
                                                  "\n"
                                                  "      0 1 2 3 4\n"
                                                  "> 0   A @ @ x b\n"
                                                  "  1   c . . . .\n"
                                                  "\n"
                                                  "x tested, not drawn\n");
    about.first_step = 3;
    EXPECT_NE(shown(trace, View::writes, about).find("> 0   1[1 1]x .  A x=0  B x=4\n"),
              std::string::npos);
}

TEST(Views, ColorsAreEscapesOnlyWhenAskedFor) {
    const Trace trace = trace_in(primitive("ABC", "#ff0000") + pixel(0, 0) + pixel(1, 0));
    FrameText about;
    about.colors = ColorDepth::truecolor;
    EXPECT_NE(shown(trace, View::shade, about)
                  .find(" \x1b[30;48;2;255;0;0m*\x1b[0m \x1b[30;48;2;255;0;0;7m*\x1b[0m . . .  A "
                        "x=0  B x=4"),
              std::string::npos);
    about.colors = ColorDepth::palette256;
    EXPECT_NE(shown(trace, View::shade, about).find("\x1b[30;48;5;196m*\x1b[0m"),
              std::string::npos);
    about.colors = ColorDepth::ansi16;
    EXPECT_NE(shown(trace, View::shade, about).find("\x1b[30;101m*\x1b[0m"), std::string::npos);
    about.colors = ColorDepth::none;
    EXPECT_EQ(shown(trace, View::shade, about).find('\x1b'), std::string::npos);
}

TEST(Views, RegionAndOverview) {
    const Trace trace = trace_in(primitive("A") + pixel(0, 0) + pixel(1, 0) + "," + primitive("B") +
                                 pixel(1, 1) + pixel(4, 1));
    FrameText about;
    about.region = Region{1, 0, 2, 1};
    EXPECT_EQ(shown(trace, View::plotted, about), "said\n"
                                                  "(x 1 to 2, y 0 to 1 of a canvas of 5 x 2)\n"
                                                  "\n"
                                                  "      1 2\n"
                                                  "  0   # .\n"
                                                  "> 1   # .\n");
    about.region.reset();
    about.is_overview = true;
    // Three columns are left: blocks of 2 x 4 pixels. a and b are drawn twice and once in the first.
    EXPECT_EQ(shown(trace, View::faces, about, {.columns = 8, .lines = 20}),
              "said\n"
              "(1 cell = 2x4 pixels, the most frequent of those drawn)\n"
              "\n"
              "     0 4\n"
              "> 0  a.b  A x=0  B x=4  C x=0\n"
              "\n"
              "a A  b B\n");
}

TEST(Views, ExamplesThatDifferAreSeenToDiffer) {
    std::map<std::string, std::pair<std::string, std::string>>
        seen; // by what is seen: name, picture
    for (const auto& entry : std::filesystem::recursive_directory_iterator(RASTERTRACE_EXAMPLES)) {
        if (entry.path().extension() != ".json")
            continue;
        const Trace trace = load_trace(entry.path().string(), {});
        ASSERT_TRUE(trace.end);
        const std::string name = entry.path().filename().string();
        const auto [other, is_new] =
            seen.emplace(grid(trace, default_view(trace)), std::pair(name, trace.end->frame));
        EXPECT_TRUE(is_new || other->second.second == trace.end->frame)
            << name << " looks like " << other->second.first;
    }
    EXPECT_GT(seen.size(), 20u);
}

} // namespace
} // namespace rastertrace
