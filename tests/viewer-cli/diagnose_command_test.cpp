// SPDX-License-Identifier: MIT
// `rastertrace diagnose` and `--mistake` as a renderer's developer meets them.

#include "program.h"

#include <rastertrace/core/draw/model/mistakes.h>
#include <rastertrace/trace/check/typed_number.h>
#include <rastertrace/trace/record/replay.h>
#include <rastertrace/trace/record/trace.h>
#include <rastertrace/trace/record/traced_steps.h>

#include <algorithm>
#include <map>
#include <sstream>
#include <string>
#include <tuple>
#include <variant>

namespace rastertrace {
namespace {

/// With two triangles of a quadrilateral as scene.json.
class DiagnoseTest : public ProgramTest {
protected:
    DiagnoseTest() {
        fs::copy(fs::path(RASTERTRACE_EXAMPLES) / "mistakes/quad.json", folder_ / "scene.json");
    }

    Outcome diagnose(const std::string& arguments) const { return run("diagnose " + arguments); }
};

TEST_F(DiagnoseTest, ATraceOfAMistakeIsThatMistake) {
    run("trace scene.json --mistake height-plus-one -o theirs.json");
    EXPECT_THAT(diagnose("scene.json theirs.json"),
                Ends(1, StartsWith("makes the mistake height-plus-one: ")));
    EXPECT_EQ(diagnose("scene.json scene.json").status, 2);
    run("trace scene.json -o right.json");
    EXPECT_EQ(diagnose("scene.json right.json").out, "drawn as the scene asks\n");
    EXPECT_EQ(diagnose("scene.json right.json").status, 0);
}

TEST_F(DiagnoseTest, ALinkInAFolderThatLeadsToNothingIsTold) {
    run("trace scene.json --mistake height-plus-one -o scene.jsonl");
    shell("mkdir pairs; mv scene.json scene.jsonl pairs; ln -s loop.json pairs/loop.json");
    EXPECT_THAT(
        diagnose("pairs"),
        Ends(1, StartsWith("makes the mistake height-plus-one: "),
             "rastertrace: pairs/loop.json: expected a file that can be read, found: Too many "
             "levels of symbolic links\n"));
}

TEST_F(DiagnoseTest, ClaimsOfSomebodyWhoRoundsOtherwiseAreThatRounding) {
    // dx/dy of AC is 23/10, and of AD 1/3: ends 23/10 and 1/3 on y = 1, 23/5 and 2/3 on y = 2, by hand.
    write("acd.json", R"({"canvas": {"width": 24, "height": 12, "origin": "top-left"},
                          "vertices": {"A": [0, 0], "C": [23, 10], "D": [3, 9]},
                          "triangles": ["ACD"]})");
    write("claims.txt",
          "y=1: 1/3, 23/10 -> 1..2\ny=2: 2/3, 23/5 -> 1..4\ny=5: 5/3, 23/2 -> 2..11\n");
    EXPECT_THAT(diagnose("acd.json claims.txt"),
                Ends(1, AllOf(StartsWith("draws by rounding inside"),
                              HasSubstr("; the scene asks for rounding floor\n"),
                              HasSubstr("3 of 3 claims that are not as the scene asks"))));
}

TEST_F(DiagnoseTest, ClaimsThatContradictEachOtherAreBadInput) {
    write("acd.json", R"({"canvas": {"width": 24, "height": 12, "origin": "top-left"},
                          "vertices": {"A": [0, 0], "C": [23, 10], "D": [3, 9]},
                          "triangles": ["ACD"]})");
    write("claims.txt", "y=1: 1/3, 23/10 -> 1..2\ny=1: 1/3, 23/10 -> 0..1\n");
    EXPECT_THAT(diagnose("acd.json claims.txt"),
                Refused(HasSubstr("claims.txt:2:1: expected claims that agree with one another, "
                                  "found one that contradicts line 1")));
}

TEST_F(DiagnoseTest, BadInputIsToldInPlainWords) {
    fs::copy(folder_ / "scene.json", folder_ / "other.json");
    EXPECT_THAT(
        diagnose("scene.json other.json").err,
        HasSubstr("other.json: expected what was drawn of scene.json, found another scene"));
    write("theirs.txt", "..#\n.##\n");
    EXPECT_THAT(diagnose("scene.json theirs.txt").err,
                HasSubstr("expected 24 x 12 pixels, as the canvas of scene.json has, found 3 x 2"));
    EXPECT_THAT(
        diagnose("scene.json other.json theirs.txt").err,
        HasSubstr("expected a scene and what was drawn of it, pair by pair, found 3 files"));
    EXPECT_EQ(diagnose("scene.json theirs.txt").status, 2);
}

TEST_F(DiagnoseTest, APictureOfAnotherSceneHasNoPixelInCommon) {
    std::string picture;
    for (int row = 0; row < 12; ++row)
        picture += row == 11 ? "#.#.#.#.#.#.#.#.#.#.#.#.\n" : "........................\n";
    write("theirs.txt", picture);
    EXPECT_THAT(
        diagnose("scene.json theirs.txt"),
        Ends(1, AllOf(StartsWith("nothing that I know: "),
                      HasSubstr("no pixel is drawn in theirs.txt and by scene.json as well"))));
}

TEST_F(DiagnoseTest, AnAntiAliasedPictureIsSaidToBeOne) {
    // The right picture in one color, with an end of each row halfway to the background.
    const std::string rows = run("show scene.json --bare --rounding half-open").out;
    std::istringstream lines(rows);
    std::string pgm = "P2\n24 12\n255\n";
    for (std::string row; std::getline(lines, row);)
        for (std::size_t i = 0; i < row.size(); ++i)
            pgm +=
                row[i] == '#' ? (i + 1 < row.size() && row[i + 1] == '.' ? "160 " : "255 ") : "0 ";
    write("theirs.pgm", pgm);
    write("white.json", R"({"canvas": {"width": 24, "height": 12, "origin": "top-left"},
         "vertices": {"A": [0, 0], "B": [20, 2], "C": [23, 10], "D": [3, 9]},
         "triangles": [{"vertices": "ABC", "color": "#ffffff"}, {"vertices": "ACD", "color": "#ffffff"}],
         "method": {"rounding": "inside"}})");
    EXPECT_THAT(diagnose("white.json theirs.pgm").out,
                AllOf(StartsWith("draws by rounding half-open"), HasSubstr("anti-aliasing"),
                      Not(HasSubstr("score 100 %"))));
}

/// What is right, or drawn with a mistake, in other colors than the scene's.
class DiagnoseColorsTest : public DiagnoseTest {
protected:
    DiagnoseColorsTest() {
        write("plain.json", scene("", ""));
        write("colored.json", scene(R"(, "color": "#ff0000")", R"(, "color": "#0000ff")"));
    }

    static std::string scene(const std::string& a, const std::string& b) {
        return R"({"canvas": {"width": 9, "height": 7, "origin": "top-left"},
            "vertices": {"A": [0, 0, 1], "B": [6, 0, 1], "C": [0, 5, 1], "D": [7, 6, 3]},
            "triangles": [{"vertices": "ABC", "name": "T1")" +
               a + R"(}, {"vertices": "ABD", "name": "T2")" + b +
               R"(}], "method": {"fill": "top-left", "depth": "linear-z"}})";
    }

    /// A PPM of rows, with a color for each of their characters.
    void write_ppm(const std::string& rows, const std::map<char, std::string>& colors) const {
        std::string text = "P3\n9 7\n255\n";
        for (const char c : rows)
            if (const auto color = colors.find(c); color != colors.end())
                text += color->second + "\n";
        write("theirs.ppm", text);
    }

    std::string rows_of(const std::string& arguments) const {
        return run("show --bare " + arguments).out;
    }
};

// A scene without colors leaves them to the renderer, and to its background.
TEST_F(DiagnoseColorsTest, ARightPictureOfASceneWithoutColorsIsRightInAnyColors) {
    for (const auto& [drawn, not_drawn, said] : {std::tuple("255 255 255", "0 0 0", "#ffffff"),
                                                 {"255 255 0", "255 255 255", "#ffff00"},
                                                 {"210 210 210", "255 255 255", "#d2d2d2"},
                                                 {"0 128 0", "30 30 60", "#008000"}}) {
        write_ppm(rows_of("plain.json"), {{'#', drawn}, {'.', not_drawn}});
        EXPECT_THAT(diagnose("plain.json theirs.ppm"),
                    Prints(std::string("drawn as the scene asks\n  remark      ") + said +
                           " in theirs.ppm is the scene's #000000\n"));
        write_ppm(rows_of("plain.json --sample integer"), {{'#', drawn}, {'.', not_drawn}});
        EXPECT_THAT(diagnose("plain.json theirs.ppm").out, StartsWith("draws by sample integer"));
    }
    write_ppm(rows_of("plain.json"), {{'#', "0 0 0"}, {'.', "0 0 0"}});
    EXPECT_EQ(diagnose("plain.json theirs.ppm").out.find("drawn as the scene asks"), 0U);
}

TEST_F(DiagnoseColorsTest, OtherColorsThanTheScenesAreTold) {
    const std::string rows = rows_of("colored.json --view faces");
    write_ppm(rows, {{'a', "0 200 0"}, {'b', "200 0 200"}, {'.', "0 0 0"}});
    EXPECT_THAT(diagnose("colored.json theirs.ppm"),
                Ends(1, "drawn as the scene asks, in other colors\n"
                        "  remark      #00c800 in theirs.ppm is the scene's #ff0000\n"
                        "  remark      #c800c8 in theirs.ppm is the scene's #0000ff\n"));
    write_ppm(rows, {{'a', "0 0 255"}, {'b', "255 0 0"}, {'.', "0 0 0"}}); // exchanged
    EXPECT_THAT(diagnose("colored.json theirs.ppm"),
                Ends(1, AllOf(StartsWith("nothing that I know: "),
                              HasSubstr("theirs.ppm draws what the scene asks for, "))));
    write_ppm(rows, {{'a', "255 255 255"}, {'b', "255 255 255"}, {'.', "0 0 0"}});
    EXPECT_THAT(diagnose("colored.json theirs.ppm"),
                Ends(1, AllOf(StartsWith("drawn as the scene asks, in other colors\n"),
                              HasSubstr("#ffffff in theirs.ppm is the scene's #0000ff"))));
}

// Without colors a trace says who has drawn what.
TEST_F(DiagnoseColorsTest, ATraceWithoutColorsIsComparedByItsPrimitives) {
    write("mixed.json", R"({"canvas": {"width": 9, "height": 7, "origin": "top-left"},
        "vertices": {"A": [0, 0], "B": [8, 0], "C": [0, 6]}, "triangles": ["ABC"],
        "colors": {"A": "#ff0000", "B": "#00ff00", "C": "#0000ff"}})");
    for (const std::string scene : {"plain.json", "colored.json", "mixed.json"}) {
        shell("$rastertrace trace " + scene +
              R"( | sed 's/,"colors\?":[^]}]*"\]\?//' > theirs.jsonl)");
        EXPECT_THAT(diagnose(scene + " theirs.jsonl"), Prints("drawn as the scene asks\n"));
    }
    shell(
        R"($rastertrace trace colored.json --depth none | sed 's/,"color":"[^"]*"//' > theirs.jsonl)");
    EXPECT_THAT(diagnose("colored.json theirs.jsonl"), Ends(1, StartsWith("draws by depth none")));
}

/// What a sentence says behind "; NAME: x = ", or another letter, up to words. "" if it does not.
std::string formula_in(const std::string& sentence, const std::string& name) {
    const std::string begin = "; " + name + ": ";
    const std::size_t at = sentence.find(begin);
    if (at == std::string::npos)
        return {};
    const std::size_t from = sentence.find(" = ", at) + 3;
    return sentence.substr(from,
                           std::min(sentence.find('\n', from), sentence.find(" on ", from)) - from);
}

TEST_F(DiagnoseTest, TheFormulaOfAMistakeGivesWhatIsTold) {
    for (const std::string name : {"dx-dy-inverted", "slope-of-zero", "step-before-first",
                                   "start-and-step-exchanged", "height-plus-one"}) {
        int found = 0;
        for (int step = 1; step < 40; ++step) {
            const std::string sentence =
                run("explain scene.json --mistake " + name + " --step " + std::to_string(step)).out;
            const std::string formula = formula_in(sentence, name);
            if (formula.empty())
                continue;
            ++found;
            const auto read = number_at(formula, {});
            ASSERT_TRUE(std::holds_alternative<TypedNumber>(read)) << formula;
            const auto value = typed_value(std::get<TypedNumber>(read).text);
            ASSERT_TRUE(value) << formula;
            EXPECT_THAT(sentence.substr(0, sentence.find("[!]")),
                        HasSubstr(" = " + value->value.get_str()))
                << formula;
        }
        EXPECT_GT(found, 1) << name;
    }
}

// T0's listing has more than one: the slope upside down, and the vertices as they are named.
TEST_F(DiagnoseTest, TwoMistakesAreDrawnTogether) {
    const auto picture = [this](const std::string& mistakes) {
        const std::string drawn = run("show scene.json --mistake " + mistakes).out;
        return drawn.substr(drawn.find('\n'));
    };
    const std::string both = picture("dx-dy-inverted,right-end-left-out");
    EXPECT_EQ(both, picture("right-end-left-out,dx-dy-inverted"));
    EXPECT_NE(both, picture("dx-dy-inverted"));
    EXPECT_NE(both, picture("right-end-left-out"));
    EXPECT_THAT(run("show scene.json --mistake dx-dy-inverted,right-end").err,
                HasSubstr("or several: a,b"));
}

// Matrices and places of a mistake are told, and redoing them from each other gives what is drawn.
TEST_F(DiagnoseTest, TheStepsOfAMistakeAreItsOwn) {
    fs::copy(fs::path(RASTERTRACE_EXAMPLES) / "mistakes/camera.json", folder_ / "camera.json");
    const auto told = [this](const std::string& options) {
        return run("trace camera.json --scalar exact --only matrix,vertex " + options).out;
    };
    for (const std::string mistake : {"camera-turned-round", "moved-after-turning"}) {
        EXPECT_THAT(told("--mistake " + mistake), HasSubstr(R"("name":"view")"));
        EXPECT_NE(told("--mistake " + mistake), told(""));
    }
}

TEST_F(DiagnoseTest, AFrameSaysThatItIsDrawnWithAMistake) {
    EXPECT_THAT(run("show scene.json --mistake height-plus-one").out,
                StartsWith("Two triangles of a quadrilateral, with height-plus-one"));
}

} // namespace
} // namespace rastertrace
