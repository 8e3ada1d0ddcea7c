// SPDX-License-Identifier: MIT
// `rastertrace figure` as a user calls it: what it says to bad input, what it keeps, and what holds for any scene.

#include "commands/figure_file.h"
#include "program.h"
#include "random_scene.h"
#include "traces.h"

#include <rastertrace/trace/record/replay.h>

#include <png.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <regex>
#include <string>
#include <string_view>
#include <vector>

namespace rastertrace {
namespace {

constexpr std::array<std::string_view, 6> endings{".svg", ".png", ".tex", ".txt", ".gif", ".html"};

class FigureTest : public ProgramTest {
protected:
    /// Of the first triangle.
    Outcome figure(const std::string& arguments) const {
        return run("figure $examples/t0-fill/first-triangle.json " + arguments);
    }

    /// The message of a figure that is refused, and that it left no file.
    std::string refusal(const std::string& arguments) const {
        const std::size_t files = visible_files();
        const std::string told =
            ProgramTest::refusal("figure $examples/t0-fill/first-triangle.json " + arguments);
        EXPECT_EQ(visible_files(), files) << arguments;
        return told;
    }
};

// --- names of files -----------------------------------------------------------------------------

TEST_F(FigureTest, AnUnknownEndingIsToldWithThoseThatAreKnown) {
    EXPECT_EQ(refusal("-o x.webp"),
              "rastertrace: x.webp: expected a name that ends in .svg, .png, .tex, .txt, .gif or "
              ".html, found .webp\n"
              "hint: --format says what to write\n");
    EXPECT_EQ(refusal("-o x"),
              "rastertrace: x: expected a name that ends in .svg, .png, .tex, .txt, .gif or "
              ".html, found none of them\n"
              "hint: --format says what to write\n");
}

TEST_F(FigureTest, APdfIsMadeOfAnSvg) {
    EXPECT_EQ(refusal("-o 'my figures/x.pdf'"),
              "rastertrace: my figures/x.pdf: expected a name that ends in .svg, .png, .tex, .txt, "
              ".gif or .html, found .pdf\n"
              "hint: of an .svg: rsvg-convert -f pdf 'my figures/x.svg' -o 'my figures/x.pdf'\n");
}

TEST_F(FigureTest, OtherCommandsTellWhoWritesAFigure) {
    const std::string scene = " $examples/t0-fill/first-triangle.json -o ";
    EXPECT_EQ(run("trace" + scene + "x.svg").err,
              "rastertrace: x.svg: expected a name that ends in .json or .jsonl, found .svg\n"
              "hint: rastertrace figure writes .svg\n");
    EXPECT_EQ(run("report" + scene + "x.png").err,
              "rastertrace: x.png: expected a name that ends in .svg, .html, .json, .csv or .txt, "
              "found .png\n"
              "hint: rastertrace figure writes .png\n");
    EXPECT_EQ(run("report" + scene + "x.webp").err,
              "rastertrace: x.webp: expected a name that ends in .svg, .html, .json, .csv or .txt, "
              "found .webp\n"
              "hint: --format says what to write\n");
    EXPECT_EQ(visible_files(), 0U);
}

TEST_F(FigureTest, WhatIsNoPlaceForAFile) {
    shell("mkdir folder.svg");
    EXPECT_EQ(refusal("-o folder.svg"),
              "rastertrace: folder.svg: expected a file to write, found a folder\n");
    EXPECT_THAT(
        figure("-o none/x.svg"),
        Ends(3, _, "rastertrace: none/x.svg: could not be created: No such file or directory\n"));
    for (const std::string_view ending : endings) {
        const std::string format = "--format " + std::string(ending.substr(1));
        for (const std::string& to :
             {std::string(" -o /dev/full"), std::string(" -o - >/dev/full")})
            EXPECT_THAT(figure(format + to),
                        Ends(3, _, HasSubstr("could not be written: No space left on device\n")))
                << format << to;
    }
}

TEST_F(FigureTest, AnOlderFileIsKeptUntilTheNewOneIsWhole) {
    write("x.svg", "older\n");
    figure("--with space -o x.svg");
    figure("--step \"scanline y=99\" -o x.svg");
    EXPECT_EQ(shell("ulimit -f 1; trap '' XFSZ; $rastertrace figure "
                    "$examples/t0-fill/first-triangle.json -o x.svg")
                  .status,
              3);
    EXPECT_EQ(content("x.svg"), "older\n");
    EXPECT_EQ(visible_files(), 1U);
    EXPECT_EQ(figure("-o x.svg").status, 0);
    EXPECT_THAT(content("x.svg"), StartsWith("<svg "));
}

TEST_F(FigureTest, StandardOutputTakesOneFigure) {
    EXPECT_THAT(figure("--format svg -o -").out, StartsWith("<svg "));
    EXPECT_EQ(refusal("--every scanline --format svg -o -"),
              "rastertrace: expected one figure for standard output, found 9\n"
              "hint: --output FILE writes a file for each, --sheet CxR some side by side\n");
    EXPECT_EQ(figure("--every scanline --format svg --sheet 3x3 -o -").status, 0);
}

// --- options ------------------------------------------------------------------------------------

TEST_F(FigureTest, ASelectorThatMatchesNothing) {
    for (const std::string option : {"--step", "--until", "--every"})
        EXPECT_EQ(refusal(option + " \"scanline y=99\" -o x.svg"),
                  "rastertrace: " + option +
                      ": expected a step of the trace, found none with y=99\n"
                      "scanline y=99\n"
                      "         ^\n"
                      "hint: scanline has y: 5, 4, 3, 2, 1, ...\n");
    EXPECT_EQ(refusal("--step scanline -o x.svg"),
              "rastertrace: --step: expected one step, found 9: 5, 7, 10, 14, 20, ...\n"
              "scanline\n"
              "^\n"
              "hint: say which, or use --every\n");
    EXPECT_EQ(refusal("--until 0 -o x.svg"),
              "rastertrace: --until: expected a step, from 1, found 0\n");
}

TEST_F(FigureTest, Parts) {
    EXPECT_EQ(refusal("--with eges -o x.svg"),
              "rastertrace: --with: expected parts out of "
              "grid,axes,edges,hidden-edges,vertices,coordinates,samples,row,"
              "pixels,current,rejected,order,depths,writes,weights,owners,levels,half-planes,"
              "errors,space,plot,title,step,legend,caption,working, found \"eges\"\n"
              "hint: did you mean edges?\n");
    EXPECT_EQ(refusal("--with grid,edges --without edges -o x.svg"),
              "rastertrace: --without: expected parts that are not in --with, found \"edges\"\n");
}

TEST_F(FigureTest, PartsThatTheSceneCannotHave) {
    struct Row {
        std::string part, more, message, hint = {};
    };
    const std::vector<Row> rows{
        {"--with space", "",
         "vertices in space, found a scene that is typed in pixels, or in clip space",
         "of a scene whose vertices have z: --keep model tells where they are"},
        {"--view space", "",
         "vertices in space, found a scene that is typed in pixels, or in clip space",
         "of a scene whose vertices have z: --keep model tells where they are"},
        {"--with errors", "", "a frame of Bresenham's line, found another",
         "--step last, or another step of such a line"},
        {"--with plot", "", "a triangle with depths of linear-z or inverse-z, found none",
         "--depth linear-z --keep depth tests a triangle that no other one can hide"},
        {"--with depths", "", "a scene with depth tests, found none",
         "--depth linear-z --keep depth tests what no other triangle can hide, too"},
        {"--with weights", "", "a fill that tests samples by weights, found none",
         "--fill barycentric"},
        {"--with row", "", "a frame with a scanline, found none",
         "--step \"scanline ...\", or another step of its row"},
        {"--with row", " --step \"scanline y=2\" --region -8,-6,8,1",
         "a frame with a scanline, found none",
         "--step \"scanline ...\", or another step of its row"},
        {"--with row", " --fill barycentric", "a scene with scanlines, found none",
         "--fill scanline draws triangles row by row"},
        {"--with half-planes", " --until 1", "a frame of a triangle, found another",
         "--step \"primitive ...\", or another step of a triangle"},
        {"--with rejected", "", "a scene with pixels that are tested and not drawn, found none",
         "--fill barycentric tests pixels beside a triangle, too"},
        {"--with rejected", " --fill barycentric --step \"sample inside=true x=0 y=0\"",
         "a frame with a pixel that was tested and not drawn, found none",
         "--step of a sample or of a depth test that fails; without --step, all of them"}};
    for (const auto& [part, more, message, hint] : rows)
        EXPECT_EQ(refusal(part + more + " -o x.svg"),
                  "rastertrace: " + part + ": expected " + message + "\nhint: " + hint + "\n");
    EXPECT_EQ(run("figure $examples/t0-hidden/two-depths.json --with plot --step \"scanline in=DEF "
                  "y=1\" -o x.svg")
                  .err,
              "rastertrace: --with plot: expected a frame with two depths along a row or a side, "
              "found fewer\n"
              "hint: --step \"scanline ...\" of a longer row\n");
    EXPECT_EQ(
        run("figure $examples/t2-lines/bresenham.json --every decide --with half-planes -o x.svg")
            .err,
        "rastertrace: --with half-planes: expected a scene with triangles on the screen, found "
        "none\n");
    // The hints help.
    EXPECT_EQ(figure("--with row --step \"scanline y=2\" -o x.svg").status, 0);
    EXPECT_EQ(figure("--with half-planes --step \"primitive\" -o x.svg").status, 0);
    EXPECT_EQ(figure("--with rejected --fill barycentric -o x.svg").status, 0);
    EXPECT_EQ(figure("--with plot,depths --depth linear-z --keep depth -o x.svg").status, 0);
    // All of its depths are 0: 1/z has no place in a plot.
    EXPECT_THAT(shell("cat x.svg").out,
                AllOf(HasSubstr(">z</text>"), Not(HasSubstr(">1/z</text>"))));
    EXPECT_EQ(figure("--with weights --fill barycentric -o x.svg").status, 0);
    // Of several frames, those that have none of it go without.
    EXPECT_EQ(figure("--with row,half-planes --every edge --sheet 3x1 -o x.svg").status, 0);
}

TEST_F(FigureTest, WhatAFormatCannotShow) {
    EXPECT_EQ(refusal("--animate -o x.png"),
              "rastertrace: --animate: expected a format that moves (svg, gif, tex), found png\n");
    EXPECT_EQ(refusal("--every scanline --sheet 2x2 -o x.txt"),
              "rastertrace: --sheet: expected a format of drawings (svg, png, tex, gif), found "
              "txt\n"
              "hint: without --sheet, --every writes a .txt for each frame\n");
    EXPECT_EQ(refusal("--every scanline --sheet 2x2 --animate -o x.svg"),
              "rastertrace: --animate: expected no --sheet, found both\n"
              "hint: --animate shows frames one after the other, --sheet side by side\n");
}

TEST_F(FigureTest, NumbersAndNames) {
    const std::string sheet =
        "expected columns and rows, like 3x4, each from 1 to 100, or spaces or ears, found ";
    EXPECT_EQ(refusal("--sheet 0x4 -o x.svg"), "rastertrace: --sheet: " + sheet + "\"0x4\"\n");
    EXPECT_EQ(refusal("--sheet 4 -o x.svg"), "rastertrace: --sheet: " + sheet + "\"4\"\n");
    EXPECT_EQ(refusal("--sheet 101x1 -o x.svg"), "rastertrace: --sheet: " + sheet + "\"101x1\"\n");
    for (const std::string wrong : {"-1", "0", "nan", "1e300", "wide"})
        EXPECT_EQ(refusal("--cell " + wrong + " -o x.svg"),
                  "rastertrace: --cell: expected a number above 0, at most 1000, found \"" + wrong +
                      "\"\n");
    EXPECT_EQ(refusal("--theme blue -o x.svg"),
              "rastertrace: --theme: expected one of auto, light, dark, found \"blue\"\n");
    EXPECT_EQ(refusal("--region 100,100,200,200 -o x.svg"),
              "rastertrace: --region: expected pixels of the canvas (x -8 to 8, y -6 to 7), found "
              "100,100,200,200\n");
    EXPECT_EQ(refusal("--against $examples/t0-hidden/two-depths.json -o x.svg"),
              "rastertrace: --against: expected a trace with the same canvas, found another one\n");
}

// --- sizes --------------------------------------------------------------------------------------

/// A scene with a small triangle, or a point where there is no room.
std::string scene_of_size(int side) {
    const std::string size = std::to_string(side);
    return R"({"canvas": {"width": )" + size + R"(, "height": )" + size +
           R"(, "origin": "top-left"}, "vertices": {"A": [0, 0], "B": [300, 20], "C": [40, 300]},)" +
           (side == 1 ? R"("points": ["A"]})" : R"("triangles": ["ABC"]})");
}

TEST_F(FigureTest, TheSmallestAndALargeCanvasInEveryFormat) {
    for (const int side : {1, 4096}) {
        write("scene.json", scene_of_size(side));
        for (const std::string_view ending : endings) {
            if (ending == ".html" && side > 1024)
                continue; // refused, see APageHasLimits
            const std::string file = "x" + std::string(ending);
            EXPECT_THAT(
                run("figure scene.json -o " + file + (ending == ".gif" ? " --step last" : "")),
                Ends(0))
                << side << ending;
            EXPECT_GT(content(file).size(), 100U) << side << ending;
        }
    }
}

TEST_F(FigureTest, WhatIsTooMuchForAFormatIsTold) {
    // Hardly two pixels beside one another have the same color, so each is a rectangle.
    write("scene.json", R"({"canvas": {"width": 600, "height": 600, "origin": "top-left"},
"vertices": {"A": [0, 0], "B": [599, 0], "C": [599, 599], "D": [0, 599]},
"triangles": ["ABC", "ACD"], "colors": {"A": "#ff0000", "B": "#00ff00", "C": "#0000ff", "D": "#ffffff"},
"method": {"scalar": "double", "fill": "barycentric", "shade": "interpolate"}})");
    run("trace scene.json --only primitive,pixel -o trace.jsonl");
    const std::string draw = "$rastertrace figure trace.jsonl --view shade ";
    EXPECT_THAT(
        shell(draw + "-o x.svg"),
        Refused(MatchesRegex("rastertrace: expected at most 200000 shapes in an SVG, found [0-9]+\n"
                             "hint: a .png holds any picture; --region takes a part of it\n")));
    EXPECT_THAT(
        shell(draw + "-o x.tex"),
        Refused(HasSubstr("hint: a .png holds any picture; --region takes a part of it\n")));
    EXPECT_EQ(shell(draw + "--region 0,0,99,99 -o x.svg").status, 0);

    EXPECT_EQ(refusal("--cell 1000 -o x.png"),
              "rastertrace: expected at most 100000000 pixels in a picture, found 34078 x 28116\n"
              "hint: a smaller --scale makes it smaller; --region takes a part of it\n");
}

TEST_F(FigureTest, FramesOfOneSizeAreDrawnOnceAsFarAsThereIsRoom) {
    std::vector<std::size_t> drawn;
    const auto draw = [&drawn](std::size_t i) {
        drawn.push_back(i);
        const auto size = static_cast<double>(i + 1);
        return Drawing{.width = size, .height = 10 - size, .title = std::to_string(i)};
    };
    const auto all_of = [](const FigureFrames& frames) {
        for (std::size_t i = 0; i < frames.count; ++i) {
            const Drawing one = frames.at(i);
            EXPECT_EQ(one.title, std::to_string(i));
            EXPECT_EQ(one.width, 4);
            EXPECT_EQ(one.height, 9);
        }
    };
    all_of(of_one_size(4, draw));
    EXPECT_THAT(drawn, ElementsAre(0, 1, 2, 3));
    drawn.clear();
    // Room for two.
    all_of(of_one_size(4, draw, 2 * memory_of(draw(0)) + 1));
    EXPECT_THAT(drawn, ElementsAre(0, 0, 1, 2, 3, 2, 3));
}

TEST_F(FigureTest, WhatMovesIsAFilmOfRowsPixelsOfLinesAndVertices) {
    /// The first lines of the sentences of a film's frames, with the signs of a keyboard.
    const auto frames = [this](const std::string& scene) {
        EXPECT_EQ(run("figure " + scene + " --animate -o film.svg").err, "");
        std::string film = content("film.svg");
        constexpr std::string_view minus = "\u2212";
        for (std::size_t at = film.find(minus); at != std::string::npos; at = film.find(minus))
            film.replace(at, minus.size(), "-");
        std::vector<std::string> captions;
        constexpr std::string_view frame = "<g class=\"frame";
        constexpr std::string_view size_of_captions = "font-size=\"11\">";
        for (std::size_t at = film.find(frame); at != std::string::npos;
             at = film.find(frame, at + 1)) {
            const std::size_t begin = film.find(size_of_captions, at) + size_of_captions.size();
            captions.push_back(film.substr(begin, film.find("</text>", begin) - begin));
        }
        return captions;
    };
    // Nine rows; of a box that is gone through sample by sample, too.
    EXPECT_THAT(frames("$examples/t0-fill/first-triangle.json"),
                ElementsAre("scanline y=5", "scanline y=4", "scanline y=3", "scanline y=2",
                            "scanline y=1", "scanline y=0", "scanline y=-1", "scanline y=-2",
                            "scanline y=-3"));
    const auto samples = frames("$examples/t3-sweep-and-box/barycentric.json");
    EXPECT_EQ(samples.size(), 9U);
    EXPECT_THAT(samples, Each(StartsWith("sample of (-4, ")));
    EXPECT_THAT(frames("$examples/t4-fan/fan.json"), Each(StartsWith("a line begins at ")));
    // Pixels of lines, not of what is filled.
    write("both.json", R"({"canvas": {"width": 5, "height": 4, "origin": "top-left"},
"vertices": {"A": [0, 0], "B": [3, 0], "C": [0, 1], "D": [1, 3], "E": [3, 3]},
"triangles": ["ABC"], "lines": ["DE"], "points": ["E"]})");
    EXPECT_THAT(frames("both.json"), ElementsAre("scanline y=0", "scanline y=1", "pixel (1, 3)",
                                                 "pixel (2, 3)", "pixel (3, 3)", "pixel (3, 3)"));
    // On the way to the screen, vertices.
    write("space.json", R"({"canvas": {"width": 5, "height": 5}, "vertices": {"A": [1, 1, 2]},
"projection": {"type": "pinhole", "distance": 2}, "viewport": {"pixels_per_unit": 1},
"method": {"scalar": "exact"}, "points": ["A"]})");
    const auto vertices = frames("space.json");
    EXPECT_THAT(vertices.front(), StartsWith("vertex A in world space: (1, 1, 2)"));
    EXPECT_EQ(vertices.back(), "pixel (1, 1)");
    // All formats that move, and a still picture if one frame was asked for.
    for (const std::string film : {"-o x.gif", "--animate -o x.svg"}) {
        EXPECT_EQ(figure(film).status, 0);
        const std::string whole = content(film.substr(film.rfind(' ') + 1));
        EXPECT_EQ(figure("--every scanline " + film).status, 0);
        EXPECT_EQ(content(film.substr(film.rfind(' ') + 1)), whole);
    }
    EXPECT_EQ(figure("--step last --animate -o x.svg").status, 0);
    EXPECT_EQ(shell("grep -c 'class=\"frame' x.svg").out, "0\n");
    EXPECT_EQ(run("figure $examples/t0-projection/turning.json --animate -o x.svg; grep -c "
                  "'class=\"frame' x.svg")
                  .out,
              "6\n")
        << "the frames of the sequence";
}

TEST_F(FigureTest, AFilmOfALargeCanvasNamesRegion) {
    // The rows of ABC are 301, of 2^24 pixels each.
    write("scene.json", scene_of_size(4096));
    for (const std::string output : {"x.gif", "x.svg --animate"}) {
        EXPECT_THAT(run("figure scene.json -o " + output),
                    Refused("rastertrace: expected at most 67108864 pixels of the canvas in a "
                            "film, found 301 frames of 16777216\n"
                            "hint: --region takes a part of the canvas; --every chooses what is a "
                            "frame, like --every primitive; --step shows one step\n"));
        EXPECT_EQ(run("figure scene.json --region 0,0,9,9 -o " + output).status, 0);
    }
}

TEST_F(FigureTest, AFilmOfMoreThan500FramesNamesEvery) {
    write("rows.json", R"({"canvas": {"width": 2, "height": 501, "origin": "top-left"},
"vertices": {"A": [0, 0], "B": [1, 0], "C": [0, 500]}, "triangles": ["ABC"]})");
    for (const std::string output : {"x.gif", "x.svg --animate"})
        EXPECT_THAT(run("figure rows.json -o " + output),
                    Refused("rastertrace: expected at most 500 rows, pixels of lines and vertices "
                            "to film, found more\n"
                            "hint: --every chooses what is a frame, like --every primitive; --step "
                            "shows one step\n"));
    EXPECT_EQ(visible_files(), 1U);
    EXPECT_EQ(run("figure rows.json --every scanline -o x.gif").status, 0);
}

TEST_F(FigureTest, BarePixelsThatAreNoneAreToldWithTheOptionThatLeavesThemOut) {
    write("off.json", R"({"canvas": {"width": 9, "height": 9},
"vertices": {"A": [20, 20], "B": [30, 20], "C": [20, 30]}, "triangles": ["ABC"]})");
    const std::string remark =
        "rastertrace: remark: expected pixels for --bare, found none drawn\n";
    const auto told = [this](const std::string& arguments) {
        const Outcome outcome = run("figure " + arguments + " --bare -o x.png");
        EXPECT_EQ(outcome.status, 0) << arguments;
        return outcome.err;
    };
    const std::string triangle = "$examples/t0-fill/first-triangle.json ";
    EXPECT_EQ(told(triangle + "--step \"edge edge=AB\""),
              remark + "hint: without --step, the figure has the pixels of later steps\n");
    EXPECT_EQ(told(triangle + "--until \"scanline y=5\""),
              remark + "hint: without --until, the figure has the pixels of later steps\n");
    EXPECT_EQ(told(triangle + "--every edge"),
              remark + "hint: without --every, the figure has the pixels of later steps\n");
    EXPECT_EQ(told(triangle + "--region -8,6,-5,7"),
              remark + "hint: without --region, the figure has the pixels outside of it\n");
    EXPECT_EQ(told("off.json"),
              remark + "hint: without --bare, the figure has grid, edges and vertices\n");
    EXPECT_EQ(told(triangle), "");
    EXPECT_EQ(told(triangle + "--region 2,5,2,5"), "");
}

TEST_F(FigureTest, AnAnimationOfTooManyFramesIsRefusedBeforeItIsDrawn) {
    write("scene.json", R"({"canvas": {"width": 400, "height": 400, "origin": "top-left"},
"vertices": {"A": [0, 0], "B": [399, 0], "C": [0, 399]}, "triangles": ["ABC"]})");
    for (const std::string output : {"x.gif", "x.svg --animate"})
        EXPECT_THAT(
            run("figure scene.json --every pixel -o " + output),
            Refused(
                "rastertrace: expected at most 10000 frames that follow one another, found 80200\n"
                "hint: --every with a rarer step, like scanline or \"pixel y=2\", makes fewer\n"));
    EXPECT_EQ(visible_files(), 1U);
}

// --- pages --------------------------------------------------------------------------------------

TEST_F(FigureTest, APageRefusesWhatItHasNot) {
    const std::string formats = "expected one of svg, png, tex, txt, gif, found html\n";
    for (const std::string option :
         {"--until 3", "--every scanline", "--with edges", "--without edges", "--caption x",
          "--region 0,0,1,1", "--bare"})
        EXPECT_THAT(refusal(option + " -o x.html"),
                    AllOf(HasSubstr(formats), HasSubstr(option.substr(0, option.find(' ')))))
            << option;
    for (const std::string option : {"--sheet 2x2", "--animate", "--seconds 1", "--scale 2",
                                     "--width 100", "--cell 10", "--against rounding=nearest"})
        EXPECT_THAT(refusal(option + " -o x.html"), HasSubstr("found html\n")) << option;
}

TEST_F(FigureTest, APageTakesWhatSaysHowItBegins) {
    EXPECT_THAT(figure("--step \"scanline y=2\" --view writes --title \"<T>\" --theme dark "
                       "--rounding nearest -o x.html"),
                Ends(0));
    EXPECT_THAT(content("x.html"),
                AllOf(HasSubstr("\"view\":\"writes\",\"step\":"),
                      HasSubstr("<title>&lt;T&gt;</title>"),
                      HasSubstr("<raster-trace whole-page theme=\"dark\">\n<svg ")));
    EXPECT_EQ(figure("--format html -o -").out, (figure("-o y.html"), content("y.html")));
}

TEST_F(FigureTest, APageHasTheModuleThatIsNamed) {
    write("mine.js", "var rastertrace = () => 'mine';");
    const std::string page = "figure $examples/t0-fill/first-triangle.json -o x.html";
    EXPECT_EQ(shell("RASTERTRACE_MODULE=mine.js $rastertrace " + page).err, "");
    EXPECT_THAT(content("x.html"),
                HasSubstr("<script>\nvar rastertrace = () => 'mine';\n</script>"));
    EXPECT_EQ(shell("RASTERTRACE_MODULE=none.js $rastertrace " + page).err,
              "rastertrace: none.js: expected a file that can be read, found: No such file or "
              "directory\n");
    for (const std::string text : {"{}", "var rastertrace = '</script>';"}) {
        write("mine.js", text);
        EXPECT_EQ(shell("RASTERTRACE_MODULE=mine.js $rastertrace " + page).err,
                  "rastertrace: mine.js: expected the module for pages, found another file\n"
                  "hint: it is share/rastertrace/rastertrace.js of an installation\n");
    }
}

TEST_F(FigureTest, APageHasLimits) {
    write("scene.json", scene_of_size(1025));
    EXPECT_EQ(run("figure scene.json -o x.html").err,
              "rastertrace: expected at most 1048576 pixels for a page, found 1025 x 1025\n"
              "hint: a .png or .svg shows it, or a page of the scene on a smaller canvas\n");
    write("scene.json", scene_of_size(400));
    EXPECT_EQ(
        run("figure scene.json --vary /vertices/A/0=0:1:9 -o x.html").err,
        "rastertrace: expected at most 200000 steps for a page, found more in the first 5 frames\n"
        "hint: --frame N makes a page of one frame\n");
    EXPECT_EQ(visible_files(), 1U);
}

TEST_F(FigureTest, FramesWithoutRoomOnAPageAreRefusedBeforeAnyIsWrittenDown) {
    // The answers about the pixels of each frame would take half a minute.
    write("scene.json", scene_of_size(102));
    EXPECT_THAT(
        shell("ulimit -t 4; $rastertrace figure scene.json --vary /vertices/A/0=0:1:90 "
              "-o x.html"),
        Refused(HasSubstr("expected at most 200000 steps for a page, found more in the first")));
}

// --- damaged traces -----------------------------------------------------------------------------

TEST_F(FigureTest, OfATraceThatIsCutShortWhatIsThere) {
    run("trace $examples/t0-fill/first-triangle.json -o whole.jsonl;head -n 19 whole.jsonl > "
        "cut.jsonl; head -n 20 whole.jsonl | tail -n 1 | head -c 18 >> cut.jsonl");
    for (const std::string_view ending : endings) {
        const std::string file = "x" + std::string(ending);
        EXPECT_THAT(run("figure cut.jsonl -o " + file),
                    Refused("rastertrace: cut.jsonl:20:1: expected the rest of the trace, found "
                            "the end of the file: the trace is truncated after 18 whole steps\n"
                            "{\"step\":\"pixel\",\"x\n"
                            "^\n"))
            << ending;
        EXPECT_GT(content(file).size(), 100U) << ending;
    }
    EXPECT_THAT(content("x.svg"), HasSubstr("<desc>17 x 14 pixels, 10 drawn.</desc>"));
}

// --- what holds for any scene -------------------------------------------------------------------

/// Random scenes that can be drawn, and their traces.
struct DrawnScene {
    std::string text;
    Trace trace;
};

std::vector<DrawnScene> drawn_scenes(int count) {
    std::vector<DrawnScene> scenes;
    for (std::uint64_t seed = 1; static_cast<int>(scenes.size()) < count; ++seed) {
        const std::string text = RandomScene(seed).text();
        auto scene = read_scene({"scene.json", text});
        if (!scene)
            continue;
        Trace trace = trace_of(scene.value().scene);
        if (trace.size() > 0)
            scenes.push_back({text, std::move(trace)});
    }
    return scenes;
}

std::size_t drawn_pixels(const Trace& trace) {
    const Frame frame = frame_after(trace, trace.size());
    return static_cast<std::size_t>(std::count_if(frame.drawn_by.begin(), frame.drawn_by.end(),
                                                  [](std::size_t step) { return step != 0; }));
}

TEST_F(FigureTest, TheSameSceneGivesTheSameBytes) {
    for (const DrawnScene& scene : drawn_scenes(5)) {
        write("scene.json", scene.text);
        for (const std::string_view ending : endings) {
            const std::string format = " --format " + std::string(ending.substr(1)) + " -o ";
            run("figure scene.json" + format + "a; $rastertrace figure scene.json" + format + "b");
            EXPECT_GT(content("a").size(), 0U) << ending << scene.text;
            EXPECT_EQ(content("a"), content("b")) << ending << scene.text;
        }
    }
}

TEST_F(FigureTest, AnSvgPaintsAsManyPixelsAsTheTraceHas) {
    const std::regex path(R"re(<path class="area (?:plotted|current)" d="([^"]*)")re");
    const std::regex rectangle(R"(h([0-9]+)v([0-9]+)h)");
    std::size_t with_pixels = 0;
    for (const DrawnScene& scene : drawn_scenes(40)) {
        write("scene.json", scene.text);
        const std::string svg =
            run("figure scene.json --view plotted --cell 3 --format svg -o -").out;
        std::size_t area = 0;
        for (std::sregex_iterator areas(svg.begin(), svg.end(), path), end; areas != end; ++areas) {
            const std::string data = (*areas)[1];
            for (std::sregex_iterator one(data.begin(), data.end(), rectangle); one != end; ++one)
                area += std::stoul((*one)[1]) * std::stoul((*one)[2]);
        }
        const std::size_t pixels = drawn_pixels(scene.trace);
        EXPECT_EQ(area, 9 * pixels) << scene.text;
        with_pixels += pixels > 0;
    }
    EXPECT_GT(with_pixels, 20U);
}

/// The pixels of a PNG file, as libpng reads them.
struct PngPixels {
    std::size_t width = 0;
    std::size_t height = 0;
    std::vector<Color> colors;
};

PngPixels read_png(const std::string& file) {
    png_image image{};
    image.version = PNG_IMAGE_VERSION;
    if (png_image_begin_read_from_memory(&image, file.data(), file.size()) == 0)
        return {};
    image.format = PNG_FORMAT_RGB;
    std::vector<std::uint8_t> bytes(PNG_IMAGE_SIZE(image));
    if (png_image_finish_read(&image, nullptr, bytes.data(), 0, nullptr) == 0)
        return {};
    PngPixels pixels{.width = image.width, .height = image.height, .colors = {}};
    for (std::size_t i = 0; i < bytes.size(); i += 3)
        pixels.colors.emplace_back(bytes[i], bytes[i + 1], bytes[i + 2]);
    return pixels;
}

TEST_F(FigureTest, ABarePictureWithoutColorsFollowsTheTheme) {
    // The first pixel of the first triangle is the 11th of the third row, of 17 each.
    constexpr std::size_t drawn = 2 * 17 + 10;
    const auto pixel_in = [this](const std::string& options) {
        return read_png(figure("--bare --format png -o - " + options).out).colors.at(drawn);
    };
    EXPECT_EQ(pixel_in("--theme light"), (Color{0, 0, 0}));
    EXPECT_EQ(pixel_in("--theme dark"), (Color{0xf4, 0xf4, 0xf4}));
    EXPECT_THAT(
        figure("--bare --format svg -o -").out,
        AllOf(HasSubstr(".ink{fill:#000000;"),
              ContainsRegex(
                  "\\(prefers-color-scheme:dark\\)\\{\n\\.r[0-9a-f]+ \\.ink\\{fill:#f4f4f4;")));
    // What has a color, or is on a background, keeps it.
    const auto in_dark = [this](const std::string& scene) {
        write("scene.json", scene);
        return read_png(run("figure scene.json --bare --theme dark --format png -o -").out).colors;
    };
    const std::string points = R"("canvas": {"width": 2, "height": 1, "origin": "top-left"},
                                  "vertices": {"A": [0, 0], "B": [1, 0]}, "points": ["A", )";
    EXPECT_THAT(in_dark("{" + points + R"({"vertices": "B", "color": "#ff0000"}]})"),
                ElementsAre(Color{0, 0, 0}, Color{255, 0, 0}));
    EXPECT_THAT(in_dark(R"({"background": "#ffffff", )" + points + R"("B"]})"),
                ElementsAre(Color{0, 0, 0}, Color{0, 0, 0}));
}

TEST_F(FigureTest, ABarePngIsThePictureOfTheTrace) {
    const Color paper{255, 255, 255};
    for (const DrawnScene& scene : drawn_scenes(40)) {
        write("scene.json", scene.text);
        const PngPixels png = read_png(run("figure scene.json --bare --format png -o -").out);
        const Canvas& canvas = scene.trace.canvas;
        ASSERT_EQ(png.width, static_cast<std::size_t>(canvas.width)) << scene.text;
        ASSERT_EQ(png.height, static_cast<std::size_t>(canvas.height)) << scene.text;
        const Frame frame = frame_after(scene.trace, scene.trace.size());
        for (std::size_t i = 0; i < png.colors.size(); ++i) {
            const Color drawn = frame.image.colors()[i];
            const Color shown =
                frame.drawn_by[i] == 0 ? paper : Color{drawn.red(), drawn.green(), drawn.blue()};
            ASSERT_EQ(png.colors[i], shown) << "pixel " << i << " of " << scene.text;
        }
    }
}

} // namespace
} // namespace rastertrace
