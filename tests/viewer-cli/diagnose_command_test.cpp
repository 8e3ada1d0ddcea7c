// SPDX-License-Identifier: MIT
// `rastertrace diagnose` and `--mistake` as a renderer's developer meets them.

#include "program.h"

#include <rastertrace/core/draw/model/mistakes.h>
#include <rastertrace/trace/check/typed_number.h>
#include <rastertrace/trace/record/frame.h>
#include <rastertrace/trace/record/trace.h>
#include <rastertrace/trace/record/traced_steps.h>

#include <algorithm>
#include <sstream>
#include <string>
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

TEST_F(DiagnoseTest, AFrameSaysThatItIsDrawnWithAMistake) {
    EXPECT_THAT(run("show scene.json --mistake height-plus-one").out,
                StartsWith("Two triangles of a quadrilateral, with height-plus-one"));
}

} // namespace
} // namespace rastertrace
