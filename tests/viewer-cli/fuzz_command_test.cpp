// SPDX-License-Identifier: MIT
// `rastertrace fuzz` drives tests/driven/rasterizer.cpp, which is right, or has one of twenty mistakes.

#include "effort.h"
#include "program.h"

#include <fmt/core.h>
#include <gmock/gmock.h>

#include <array>
#include <regex>
#include <string>

namespace rastertrace {
namespace {

using ::testing::AllOf;
using ::testing::ContainsRegex;
using ::testing::HasSubstr;
using ::testing::StartsWith;

class FuzzTest : public ProgramTest {
protected:
    Outcome fuzz(const std::string& options, const std::string& words = "{triangles}") const {
        return shell("$rastertrace fuzz --fill top-left --scalar exact " + options + " -- " +
                     std::string(RASTERTRACE_DRIVEN) + " " + words);
    }

    std::string path_of_rasterizer() const { return RASTERTRACE_DRIVEN; }
};

struct PlantedMistake {
    int number;
    std::string kind;     ///< of scenes that show it
    std::size_t vertices; ///< the fewest that do
    std::string ends;     ///< how the program is found to fail
};

const std::array<PlantedMistake, 20> mistakes{{
    {1, "2d", 3, "decides otherwise"},
    {2, "2d", 3, "decides otherwise"},
    {3, "2d", 3, "decides otherwise"},
    {4, "2d", 3, "decides otherwise"},
    {5, "2d", 3, "decides otherwise"},
    {6, "2d", 3, "decides otherwise"},
    {7, "2d", 3, "decides otherwise"},
    {8, "2d", 3, "decides otherwise"},
    {9, "2d", 3, "decides otherwise"},
    {10, "2d", 3, "decides otherwise"},
    {11, "2d", 3, "decides otherwise"},
    {12, "2d", 3, "decides otherwise"},
    {13, "2d", 3, "hangs"},
    {14, "2d", 3, "does not end well"},
    {15, "depth", 3, "decides otherwise"},
    {16, "depth", 3, "decides otherwise"},
    {17, "depth", 3, "decides otherwise"},
    {18, "depth", 3, "decides otherwise"},
    {19, "lines", 1, "decides otherwise"},
    {20, "lines", 2, "decides otherwise"},
}};

TEST_F(FuzzTest, FindsEachOfTwentyMistakesAndShrinksIt) {
    for (const PlantedMistake& mistake : mistakes) {
        const bool has_depth = mistake.kind == "depth";
        const Outcome told =
            fuzz(fmt::format("--runs 1000 --time 1 --kinds {}{}", mistake.kind,
                             has_depth ? " --depth linear-z" : ""),
                 fmt::format("{{triangles}} {}{}", mistake.number, has_depth ? " depth" : ""));
        SCOPED_TRACE(fmt::format("mistake {}\n{}{}", mistake.number, told.out, told.err));
        EXPECT_EQ(told.status, 1);
        EXPECT_THAT(told.out, ContainsRegex("^seed [0-9]+: .* " + mistake.ends));
        std::smatch found;
        ASSERT_TRUE(std::regex_search(
            told.out, found,
            std::regex(R"(shrunk by \d+ runs? to (\d+) (?:triangle|line)s?, (\d+) vert)")));
        EXPECT_LE(std::stoul(found[2]), mistake.vertices + 3);

        // What is written fails as long as the program has the mistake, and says no more of it.
        const Outcome script = shell("PATH=$(dirname $rastertrace):$PATH; sh fuzz/seed-*.sh");
        EXPECT_NE(script.status, 0) << script.out;
        if (mistake.ends == "decides otherwise") {
            EXPECT_EQ(script.status, 1) << script.out << script.err;
        }
        shell("sed -i 's/ " + std::to_string(mistake.number) +
              "\\( depth\\)\\? > / 0\\1 > /' fuzz/seed-*.sh");
        const Outcome mended = shell("PATH=$(dirname $rastertrace):$PATH; sh fuzz/seed-*.sh");
        EXPECT_EQ(mended.status, 0) << mended.out << mended.err << shell("cat fuzz/*.sh").out;
        shell("rm -r fuzz");
    }
}

TEST_F(FuzzTest, ARasterizerWithoutMistakesPasses) {
    for (const std::string kind : {"2d", "lines", "depth"}) {
        const Outcome told = fuzz(fmt::format("--runs {} --kinds {}{}", random_cases(700), kind,
                                              kind == "depth" ? " --depth linear-z" : ""),
                                  kind == "depth" ? "{triangles} 0 depth" : "{triangles}");
        EXPECT_EQ(told.status, 0) << told.out << told.err;
        EXPECT_EQ(told.out,
                  fmt::format("{0} runs, seeds 1 to {0}: no difference\n", random_cases(700)));
    }
    EXPECT_EQ(visible_files(), 0U);
}

TEST_F(FuzzTest, TheSameIsFoundWhateverTheJobs) {
    const auto found = [&](int jobs) {
        return fuzz(fmt::format("--jobs {} -o one", jobs), "{triangles} 3").out;
    };
    EXPECT_EQ(found(1), found(4));
}

TEST_F(FuzzTest, AnswersMayBePicturesAndFiles) {
    // The rows that the program's own trace shows, and a file.
    write("rows.sh", path_of_rasterizer() + " $1 $2 > mine.jsonl; " +
                         std::string(RASTERTRACE_PROGRAM) +
                         " show mine.jsonl --last --bare > \"$3\"\n");
    const auto with = [&](const std::string& mistake) {
        return shell(
            "$rastertrace fuzz --runs 60 --jobs 1 --shrink 40 --fill top-left --scalar exact "
            "-- sh rows.sh {triangles} " +
            mistake + " {out}");
    };
    EXPECT_EQ(with("0").status, 0) << with("0").out;
    const Outcome told = with("11");
    EXPECT_EQ(told.status, 1) << told.err;
    EXPECT_THAT(told.out, AllOf(HasSubstr("decides otherwise"), HasSubstr("pixel ("),
                                HasSubstr("the pictures: ")));
}

// A picture that is drawn nearly all over, and the options that the written test needs.
TEST_F(FuzzTest, PicturesWithColorsAndTheOptionsOfTheTest) {
    write("ppm.sh",
          path_of_rasterizer() + " $1 $2 > mine.jsonl; " +
              "set -- $(head -n 1 $1); echo P2 $2 $3 1 > mine.pgm; " +
              std::string(RASTERTRACE_PROGRAM) +
              " show mine.jsonl --last --bare | tr '.#' '01' | sed 's/./& /g' >> mine.pgm; "
              "cat mine.pgm\n");
    const auto with = [&](const std::string& options, const std::string& mistake) {
        return shell("$rastertrace fuzz --largest 4 --runs 60 --jobs 1 --shrink 40 --fill top-left "
                     "--scalar exact " +
                     options + " -- sh ppm.sh {triangles} " + mistake);
    };
    EXPECT_EQ(with("", "0").status, 0) << with("", "0").out;
    EXPECT_EQ(with("", "11").status, 1);
    const Outcome told = fuzz("--only pixel --tolerance 2ulp -o found", "{triangles} 3");
    EXPECT_EQ(told.status, 1);
    EXPECT_THAT(shell("cat found/*.sh").out, HasSubstr("--only pixel"));
    EXPECT_THAT(shell("cat found/*.sh").out, HasSubstr("--tolerance 2ulp"));
}

// Scenes in every text, of every kind: ours is a program that agrees with us.
TEST_F(FuzzTest, OurProgramAgreesWithItself) {
    for (const std::string options :
         {"--kinds 2d,lines,depth,clip -- $rastertrace trace {scene}",
          "--kinds clip --convention direct3d -- $rastertrace trace {scene}",
          "--kinds 2d,clip -- $rastertrace trace {cs418}",
          "--kinds 2d,lines --line dda -- $rastertrace trace --line dda {triangles}"}) {
        const Outcome told = shell("$rastertrace fuzz --runs 40 " + options);
        EXPECT_EQ(told.status, 0) << options << told.out << told.err;
    }
}

// The text that is written is read by every command.
TEST_F(FuzzTest, TheTextOfTrianglesIsAScene) {
    fuzz("-o found --kinds 2d", "{triangles} 11");
    fuzz("-o found --kinds lines", "{triangles} 20");
    const Outcome told = shell("for f in found/*.txt; do $rastertrace diff --fill top-left "
                               "--scalar exact --ignore header,primitive.color,pixel.color "
                               "--common ${f%.txt}.golden.jsonl $f || exit; done");
    EXPECT_EQ(told.status, 0) << told.out << told.err;
    write("bad.txt", "canvas 4 4\ntri A 0 0 0 1 x 0 1 0 0\n");
    EXPECT_THAT(shell("$rastertrace show bad.txt").err,
                HasSubstr("bad.txt:2:15: expected a number, found x"));
    write("bad.txt", "canvas 4 4\ntri A 0 0 0 1 0\n");
    EXPECT_THAT(shell("$rastertrace show bad.txt").err,
                HasSubstr("expected a name and 9 numbers behind tri"));
    write("bad.txt", "canvas 4\n");
    EXPECT_THAT(shell("$rastertrace show bad.txt").err,
                HasSubstr("bad.txt:1:1: expected `canvas W H`"));
}

TEST_F(FuzzTest, BadInput) {
    EXPECT_THAT(shell("$rastertrace fuzz -- true").err, HasSubstr("expected a program behind --"));
    EXPECT_EQ(shell("$rastertrace fuzz -- true").status, 2);
    EXPECT_THAT(shell("$rastertrace fuzz -- ./nothing {scene}").err, HasSubstr("could not be run"));
    EXPECT_THAT(shell("$rastertrace fuzz --kinds 3d -- true {scene}").err,
                HasSubstr("--kinds: expected"));
    EXPECT_THAT(shell("$rastertrace fuzz --runs 0 -- true {scene}").err,
                HasSubstr("--runs: expected"));
    EXPECT_THAT(shell("$rastertrace fuzz -- true {scene} {cs418}").err,
                HasSubstr("expected one text of the scene"));
    const Outcome silent = shell("$rastertrace fuzz -- true {scene}");
    EXPECT_EQ(silent.status, 1);
    EXPECT_THAT(silent.out, StartsWith("seed 1: true gives no answer"));
    const Outcome failing =
        shell("$rastertrace fuzz -- sh -c 'echo no triangle >&2; exit 7' {scene}");
    EXPECT_THAT(failing.out, HasSubstr("exit status 7: no triangle"));
}

} // namespace
} // namespace rastertrace
