// SPDX-License-Identifier: MIT
// `rastertrace explain` as a user calls it: what it prints, and what it says to bad input.

#include "program.h"

#include <nlohmann/json.hpp>

#include <string>
#include <utility>
#include <vector>

namespace rastertrace {
namespace {

class ExplainTest : public ProgramTest {
protected:
    Outcome explain(const std::string& arguments) const {
        return run("explain $examples/t0-fill/first-triangle.json " + arguments);
    }
};

TEST_F(ExplainTest, APixelThatIsNotDrawn) {
    EXPECT_THAT(explain("--pixel 4,2"),
                Prints("First triangle\n"
                       "pixel (4, 2): not drawn: ABC does not cover it\n"
                       "\n"
                       "not drawn by\n"
                       "  ABC  outside  AC ends row y=2 at x = 25/8 -> floor -> 3; x = 4 lies "
                       "beyond it by 7/8\n"
                       "      right AC: x = (x2 - x1)/(y2 - y1) (y - y1) + x1 = (5 - 2)/(-3 - 5) "
                       "(2 - 5) + 2 = (-3/8) (-3) + 2 = 25/8 -> floor -> 3\n"));
}

TEST_F(ExplainTest, AnswersInPortuguese) {
    EXPECT_EQ(explain("--pixel 4,2 --language pt").out,
              "First triangle\n"
              "pixel (4, 2): não desenhado: ABC não o cobre\n"
              "\n"
              "não desenhado por\n"
              "  ABC  fora  AC termina a linha y=2 em x = 25/8 -> floor -> 3; x = 4 fica 7/8 além\n"
              "      direita AC: x = (x2 - x1)/(y2 - y1) (y - y1) + x1 = (5 - 2)/(-3 - 5) (2 - 5) "
              "+ 2 = (-3/8) (-3) + 2 = 25/8 -> floor -> 3\n");
    EXPECT_THAT(explain("--pixel -1,2 --against rounding=truncate --language pt").out,
                AllOf(HasSubstr("pixel (-1, 2): desenhado por ABC no passo 15\n"
                                "\n"
                                "passo antes  depois\n"
                                "  15  vazio  ABC #000000  pixel (-1, 2)   linha y=2: -1 a 3\n"),
                      HasSubstr("\ncom rounding=truncate: não desenhado: ABC não o cobre\n"),
                      HasSubstr("\na primeira decisão que difere\n"
                                "  como é             passo 14: linha y=2   esquerda AB")));
    // The reason is a code in JSON.
    const auto answer = nlohmann::json::parse(explain("--pixel 4,2 --language pt --json").out);
    EXPECT_EQ(answer["answer"], "não desenhado: ABC não o cobre");
    EXPECT_EQ(answer["why_not"][0]["reason"], "outside");
    EXPECT_EQ(explain("--pixel 40,2 --language pt").err, explain("--pixel 40,2").err);
}

TEST_F(ExplainTest, TakesAPixelAsItIsPrinted) {
    const std::string told = explain("--pixel 4,2").out;
    for (const char* const pixel : {"(4,2)", "(4, 2)", "4, 2", " ( 4 , 2 ) "})
        EXPECT_EQ(explain("--pixel '" + std::string(pixel) + "'").out, told) << pixel;
    EXPECT_THAT(explain("--pixel '(-1, 2)'").out, HasSubstr("\npixel (-1, 2): drawn by ABC"));
    for (const char* const other : {"(4,2", "4,2)", "(4 2)", "((4,2))", "()", "4,2,1", "1 4,2"})
        EXPECT_EQ(explain("--pixel '" + std::string(other) + "'").status, 2) << other;
}

TEST_F(ExplainTest, AColorInAPerspectiveIsWorkedOutFromTheDepths) {
    // By the 1/z of the corners or, without such depths, by their w in clip space.
    const std::string ramp = "$rastertrace explain $examples/tutorial/light/ramp.json --pixel 0,0";
    EXPECT_THAT(shell(ramp).out,
                HasSubstr("      weights of A, B, C: 1/4, 1/4, 1/2, divided by z = 1, 1, 3: 1/4, "
                          "1/4, 1/6, together 2/3\n"
                          "      divided by 2/3: 3/8 of A, 3/8 of B, 1/4 of C\n"
                          "      red = 0.375 (0) + 0.375 (0) + 0.25 (255) = 63.75 -> 64\n"));
    EXPECT_THAT(shell(ramp + " --language pt").out,
                HasSubstr("      pesos de A, B, C: 1/4, 1/4, 1/2, divididos por z = 1, 1, 3: 1/4, "
                          "1/4, 1/6, ao todo 2/3\n"
                          "      dividido por 2/3: 3/8 de A, 3/8 de B, 1/4 de C\n"));
    EXPECT_THAT(shell(ramp + " --depth none").out,
                HasSubstr("      weights of A, B, C: 1/4, 1/4, 1/2, divided by w = 1, 1, 3: 1/4, "
                          "1/4, 1/6, together 2/3\n"));
}

TEST_F(ExplainTest, JsonHasTheStepsWithWhatIsSaidOfThem) {
    const auto told = nlohmann::json::parse(explain("--pixel -1,2 --json").out);
    EXPECT_EQ(told["question"], "pixel (-1, 2)");
    const auto& one = told["tries"].at(0);
    EXPECT_EQ(one["step"], "pixel");
    EXPECT_EQ(one["x"], -1);
    EXPECT_EQ(one["number"], 15);
    EXPECT_EQ(one["sentence"], "pixel (-1, 2)   row y=2: -1 to 3");
    EXPECT_EQ(one["before"], "empty");
    EXPECT_EQ(one["after"], "ABC #000000");
    EXPECT_EQ(told["why_not"].size(), 0U);
    EXPECT_EQ(explain("--pixel -1,2 --format json").out, explain("--pixel -1,2 --json").out);
}

TEST_F(ExplainTest, AgainstAnotherMethod) {
    EXPECT_THAT(explain("--pixel -1,2 --against rounding=truncate").out,
                AllOf(HasSubstr("pixel (-1, 2): drawn by ABC at step 15\n"),
                      HasSubstr("\nwith rounding=truncate: not drawn: ABC does not cover it\n"),
                      HasSubstr("\nthe first decision that differs\n"
                                "  as it is           step 14: scanline y=2 "),
                      HasSubstr("\n  rounding=truncate  step 14: scanline y=2 ")));
    const auto answer =
        nlohmann::json::parse(explain("--pixel -1,2 --against rounding=truncate --json").out);
    EXPECT_EQ(answer["first_difference"]["here"]["from"], -1);
    EXPECT_EQ(answer["first_difference"]["there"]["from"], 0);
    EXPECT_EQ(answer["against"]["method"], "rounding=truncate");
}

/// Whole messages: what was expected, what was found, and what is near.
TEST_F(ExplainTest, BadInput) {
    const std::vector<std::pair<std::string, std::string>> cases{
        {"--pixel 9,2", "rastertrace: --pixel: expected a pixel of the canvas (x -8 to 8, y -6 to "
                        "7), found 9,2\n"},
        {"--scanline 8",
         "rastertrace: --scanline: expected a row of the canvas (y -6 to 7), found 8\n"},
        {"--pixel 4", "rastertrace: --pixel: expected a pixel as x,y, like 4,2, found \"4\"\n"},
        {"--pixel 4,2,1",
         "rastertrace: --pixel: expected a pixel as x,y, like 4,2, found \"4,2,1\"\n"},
        {"--scanline 1.5", "rastertrace: --scanline: expected the y of a row, like 2, found "
                           "\"1.5\"\n"},
        {"--face ABD", "rastertrace: --face: expected the name of a face, found \"ABD\"\n"
                       "hint: did you mean ABC?\n"},
        {"--vertex Q", "rastertrace: --vertex: expected the name of a vertex, found \"Q\"\n"
                       "hint: there are A, B, C\n"},
        {"--edge AZ", "rastertrace: --edge: expected the name of an edge, found \"AZ\"\n"
                      "hint: did you mean AB?\n"},
        {"--pair ABC", "rastertrace: --pair: expected two triangles, like ABC,ACD, found "
                       "\"ABC\"\n"},
        {"--pair ABC,ACD",
         "rastertrace: --pair: expected the name of a triangle that is drawn, found \"ACD\"\n"
         "hint: did you mean ABC?\n"},
        {"--step scanline", "rastertrace: --step: expected one step, found 9: 5, 7, 10, 14, 20, "
                            "...\nscanline\n^\nhint: say which\n"},
        {"--pixel 1,1 --against rounding=trunk",
         "rastertrace: --against: expected rounding out of floor, nearest, truncate, inside, "
         "half-open, found \"trunk\"\nrounding=trunk\n         ^\n"},
        {"--pixel 1,1 --format csv",
         "rastertrace: --format: expected text or json, found \"csv\"\n"},
    };
    for (const auto& [arguments, message] : cases)
        EXPECT_THAT(explain(arguments), Ends(2, "", message)) << arguments;
}

TEST_F(ExplainTest, ATraceIsDrawnAlready) {
    run("trace $examples/t0-fill/first-triangle.json -o t.json");
    EXPECT_EQ(run("explain t.json --pixel 4,2").out, explain("--pixel 4,2").out);
    EXPECT_THAT(run("explain t.json --pixel 4,2 --against rounding=truncate"),
                Refused("rastertrace: t.json: expected a scene to draw with --rounding truncate, "
                        "found a trace, which is drawn already\n"));
}

} // namespace
} // namespace rastertrace
