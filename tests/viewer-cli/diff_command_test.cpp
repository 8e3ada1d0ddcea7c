// SPDX-License-Identifier: MIT
// `rastertrace diff` as a user calls it: what it prints, and what it says to bad input.

#include "program.h"

#include <nlohmann/json.hpp>

#include <string>

namespace rastertrace {
namespace {

class DiffTest : public ProgramTest {
protected:
    DiffTest() {
        run("trace $examples/t0-fill/first-triangle.json -o a.json;sed "
            "'s|\"y\":2,\"left\":\"-1/4\"|\"y\":2,\"left\":\"-1/2\"|' a.json > b.json");
    }
};

TEST_F(DiffTest, OneNumberOfOneRow) {
    EXPECT_THAT(diff("a.json b.json"),
                Ends(1,
                     "a: a.json\n"
                     "b: b.json\n"
                     "1 step differs\n"
                     "\n"
                     "the first difference, in ABC\n"
                     "a   step 13 (line 14): pixel (2, 3)   row y=3: 0 to 2\n"
                     "a > step 14 (line 15): scanline y=2   left AB: x = 2 + 3/4 (2 - 5) = -1/4 -> "
                     "floor -> -1   right AC: x = 2 - 3/8 (2 - 5) = 25/8 -> floor -> 3\n"
                     "a   step 15 (line 16): pixel (-1, 2)   row y=2: -1 to 3\n"
                     "b   step 13 (line 14): pixel (2, 3)   row y=3: 0 to 2\n"
                     "b > step 14 (line 15): scanline y=2   left AB: x = 2 + 3/4 (2 - 5) = -1/2 -> "
                     "floor -> -1   right AC: x = 2 - 3/8 (2 - 5) = 25/8 -> floor -> 3   [!] its "
                     "numbers give left = -1/4\n"
                     "b   step 15 (line 16): pixel (-1, 2)   row y=2: -1 to 3\n"
                     "    left: -1/4 in a, -1/2 in b, 0.25 apart\n"
                     "    it changes no pixel\n"
                     "\n"
                     "steps     changed  only a  only b  moved\n"
                     "scanline        1       .       .      .   left 1 (by at most 0.25)\n"
                     "\n"
                     "the pictures are alike\n",
                     ""));
}

TEST_F(DiffTest, OneNumberOfOneRowInPortuguese) {
    EXPECT_THAT(
        diff("a.json b.json --language pt").out,
        AllOf(
            StartsWith("a: a.json\n"
                       "b: b.json\n"
                       "1 passo difere\n"
                       "\n"
                       "primeira diferença, em ABC\n"
                       "a   passo 13 (linha 14 do arquivo): pixel (2, 3)   linha y=3: 0 a 2\n"),
            HasSubstr("    left: -1/4 em a, -1/2 em b, 0.25 de distância\n"
                      "    não muda nenhum pixel\n"
                      "\n"
                      "passos    mudados  só em a  só em b  movidos\n"
                      "scanline        1        .        .        .   left 1 (por no máximo 0.25)\n"
                      "\n"
                      "as imagens são iguais\n")));
    EXPECT_EQ(diff("a.json a.json --language pt").out, "a: a.json\n"
                                                       "b: a.json\n"
                                                       "ambos são o mesmo arquivo\n"
                                                       "iguais, byte a byte\n");
}

TEST_F(DiffTest, AnotherMethodLosesPixels) {
    EXPECT_THAT(
        diff("$examples/t0-fill/first-triangle.json --against rounding=truncate"),
        Ends(1, AllOf(HasSubstr("    from: -1 in a, 0 in b, 1 apart\n"
                                "    1 pixel differs because of it\n"
                                "        only in a: (-1, 2)\n"),
                      HasSubstr("scanline        4       .       .      .   from 4 (by at most 1)\n"
                                "pixel           .       4       .      .\n"
                                "\n"
                                "the pictures: 4 pixels only in a\n"),
                      HasSubstr(" 2  .......!####.....\n"
                                " 1  .......#####.....\n"
                                " 0  ......!#####.....\n"
                                "-1  .....!#######....\n"
                                "-2  ....!########....\n"))));
}

TEST_F(DiffTest, ASceneIsDrawnAndExactIsLikeDouble) {
    EXPECT_EQ(diff("a.json $examples/t0-fill/first-triangle.json").status, 0);
    EXPECT_THAT(diff("a.json $examples/t0-fill/first-triangle.json --scalar double"),
                Ends(1, HasSubstr("no step differs\n"
                                  "\n"
                                  "the header\n"
                                  "    method.scalar: exact in a, double in b\n"
                                  "    numbers: fractions of 64 bits in a, none in b\n"
                                  "\n"
                                  "the pictures are alike\n")));
    EXPECT_EQ(
        diff("a.json $examples/t0-fill/first-triangle.json --scalar double --ignore header").status,
        0);
    EXPECT_EQ(diff("$examples/t0-fill/first-triangle.json --against scalar=double").status, 0);
}

TEST_F(DiffTest, AFrameOfASequence) {
    const std::string scene =
        "$examples/t0-fill/first-triangle.json --vary /vertices/A/0=2:5:4 --frame ";
    run("trace " + scene + "1 -o first.json; $rastertrace trace " + scene + "4 -o last.json");
    EXPECT_EQ(diff("first.json " + scene + "1").status, 0);
    EXPECT_EQ(diff("last.json " + scene + "4").status, 0);
    EXPECT_EQ(diff("last.json " + scene + "1").status, 1);
}

TEST_F(DiffTest, OneOfTheTwoMayComeFromAPipe) {
    EXPECT_EQ(diff("a.json - < b.json").status, 1);
    EXPECT_EQ(shell("cat a.json | $rastertrace diff - a.json").status, 0);
    EXPECT_EQ(shell("cat b.json | $rastertrace diff - a.json").status, 1);
}

TEST_F(DiffTest, JsonHasTheSame) {
    const auto told = nlohmann::json::parse(diff("a.json b.json --json").out);
    EXPECT_EQ(told["same"], false);
    EXPECT_EQ(told["first"]["a"]["number"], 14);
    EXPECT_EQ(told["first"]["a"]["line"], 15);
    EXPECT_EQ(told["first"]["a"]["step"]["left"], "-1/4");
    EXPECT_EQ(told["first"]["b"]["step"]["left"], "-1/2");
    EXPECT_EQ(told["first"]["fields"][0]["distance"], 0.25);
    EXPECT_EQ(told["kinds"][0]["kind"], "scanline");
    EXPECT_EQ(told["kinds"][0]["changed"], 1);
    EXPECT_EQ(told["picture"]["only_a"], 0);
    EXPECT_EQ(nlohmann::json::parse(diff("a.json a.json --json").out)["same"], true);

    // Characters that a terminal obeys do not reach it.
    shell("printf '{\"rastertrace\":1,\"title\":\"\\302\\233\","
          "\"canvas\":{\"width\":1,\"height\":1}}\\n{\"end\":{}}\\n' > d.jsonl");
    const std::string safe = diff("a.json d.jsonl --json").out;
    EXPECT_THAT(safe, Not(HasSubstr("\302\233")));
    EXPECT_EQ(nlohmann::json::parse(safe)["header"][0]["b"], "\302\233");
}

TEST_F(DiffTest, NaNEqualsNaN) {
    const auto with = [this](const std::string& name, const std::string& left,
                             const std::string& more = "") {
        write(name, R"({"rastertrace":1,"canvas":{"width":3,"height":1,"origin":"top-left"}})"
                    "\n"
                    R"({"step":"scanline","y":0,"left":)" +
                        left + R"(,"right":"inf","from":0,"to":1)" + more + "}\n{\"end\":{}}\n");
    };
    with("a.jsonl", R"("NaN")");
    with("b.jsonl", R"("NaN")", R"(,"mine":1)");
    with("c.jsonl", "1");
    with("d.jsonl", R"("-inf")");
    EXPECT_EQ(diff("a.jsonl b.jsonl --ignore scanline.mine").out,
              "a: a.jsonl\nb: b.jsonl\nthe same\n");
    for (const char* const other : {"c.jsonl", "d.jsonl"}) {
        const auto told = nlohmann::json::parse(
            diff(std::string("a.jsonl ") + other + " --tolerance 1e9 --json").out);
        EXPECT_EQ(told["same"], false);
        EXPECT_EQ(told["first"]["fields"].size(), 1U);
        EXPECT_EQ(told["first"]["fields"][0]["a"], "NaN");
        EXPECT_FALSE(told["first"]["fields"][0].contains("distance"));
    }
}

TEST_F(DiffTest, WhatIsWrongIsSaid) {
    shell("head -c 2000 a.json > cut.json; echo nothing > empty.json");
    EXPECT_THAT(diff("a.json cut.json"),
                Ends(2, HasSubstr("the same, as far as they go\n"),
                     "rastertrace: cut.json:21:1: expected the rest of the trace, found the end of "
                     "the file: the trace is truncated after 19 whole steps\n"));
    for (const char* const cut_off : {"a.json cut.json", "cut.json a.json", "cut.json cut.json"})
        EXPECT_TRUE(
            nlohmann::json::parse(diff(cut_off + std::string(" --json")).out)["same"].is_null())
            << cut_off;
    EXPECT_EQ(refusal("diff a.json"), "rastertrace: diff: expected two files, found 1\n");
    EXPECT_EQ(refusal("diff - -"),
              "rastertrace: standard input: expected one of the two there, found both\n");
    EXPECT_THAT(refusal("diff a.json none.json"), HasSubstr("No such file or directory"));
    EXPECT_THAT(refusal("diff a.json ."), HasSubstr("expected a file, found a folder"));
    EXPECT_THAT(refusal("diff a.json empty.json"), HasSubstr("empty.json:1:1: "));
    EXPECT_THAT(refusal("diff a.json b.json --fill fan"),
                HasSubstr("expected a scene to draw with --fill fan, found a trace"));
    EXPECT_THAT(refusal("diff a.json --against fill=fan"), HasSubstr("found a trace"));
    EXPECT_THAT(refusal("diff a.json b.json --tolerance scanline.lft=1"),
                HasSubstr("found lft\nhint: did you mean left?"));
    EXPECT_THAT(refusal("diff a.json b.json --tolerance much"),
                HasSubstr("like scanline.left=1e-9"));
    EXPECT_THAT(refusal("diff a.json b.json --ignore pixl"),
                HasSubstr("hint: did you mean pixel?"));
    EXPECT_THAT(refusal("diff a.json b.json --format xml"),
                HasSubstr("--format: expected text or json, found \"xml\""));
    EXPECT_THAT(refusal("diff a.json b.json >> a.json"), HasSubstr("standard output"));
    EXPECT_THAT(diff("a.json a.json").out, HasSubstr("both are the same file\n"));
}

TEST_F(DiffTest, NothingThatWasComparedIsNotTheSame) {
    for (const std::string files : {"a.json b.json", "a.json a.json"})
        for (const std::string left_out : {"--only depth", "--only depth --ignore header",
                                           "--ignore primitive,edge,scanline,pixel,header"})
            EXPECT_THAT(refusal("diff " + files + " " + left_out),
                        HasSubstr("nothing was compared: expected steps that are not left out, "
                                  "found none in a.json and "))
                << files << left_out;
    // A golden of few kinds, of which the scene has none.
    write("golden.jsonl",
          R"({"rastertrace":1,"canvas":{"width":17,"height":14,"origin":"center"},"only":["depth"]}
{"end":{"steps":0}}
)");
    EXPECT_THAT(refusal("diff golden.jsonl a.json --only depth --ignore header"),
                HasSubstr("nothing was compared"));
}

TEST_F(DiffTest, ARenamedPrimitiveIsOneDifference) {
    shell("sed 's|\"name\":\"ABC\"|\"name\":\"T1\"|' a.json > renamed.json");
    EXPECT_THAT(diff("a.json renamed.json"),
                Ends(1, AllOf(HasSubstr("\n1 step differs\n"),
                              HasSubstr("\n    renamed: ABC in a is T1 in b\n"),
                              HasSubstr("\nprimitive        1       .       .      .   name 1\n\n"
                                        "the pictures are alike\n"))));
    EXPECT_THAT(diff("a.json renamed.json --language pt").out,
                HasSubstr("\n    com outro nome: ABC em a é T1 em b\n"));
    EXPECT_EQ(diff("a.json renamed.json --ignore primitive.name").status, 0);
}

TEST_F(DiffTest, ColorsAreForTerminals) {
    EXPECT_THAT(diff("a.json b.json").out, Not(HasSubstr("\x1b")));
    const std::string colored = diff("a.json b.json --color always").out;
    EXPECT_THAT(colored, HasSubstr("\x1b["));
    write("colored.txt", colored);
    EXPECT_EQ(shell("sed 's/\\x1b\\[[0-9;]*m//g' colored.txt").out, diff("a.json b.json").out);
}

TEST_F(DiffTest, SeveralGoldensMayBeAccepted) {
    shell("cp a.json a.golden.json");
    EXPECT_EQ(diff("a.golden.json b.json").status, 1);
    shell("cp b.json a.gcc.golden.json");
    EXPECT_THAT(diff("a.golden.json b.json"),
                Prints(HasSubstr("a.gcc.golden.json is accepted besides a.golden.json\n")));
    // None of another name.
    shell("mv a.gcc.golden.json ab.golden.json; cp b.json a.golden.gcc.json");
    EXPECT_EQ(diff("a.golden.json b.json").status, 1);
}

} // namespace
} // namespace rastertrace
