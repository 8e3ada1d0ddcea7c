// SPDX-License-Identifier: MIT
// `rastertrace fuzz` drives tests/driven/rasterizer.cpp, which is right, or has one of 22 mistakes.

#include "effort.h"
#include "program.h"

#include <fmt/core.h>

#include <array>
#include <regex>
#include <string>
#include <tuple>
#include <utility>

namespace rastertrace {
namespace {

class FuzzTest : public ProgramTest {
protected:
    Outcome fuzz(const std::string& options, const std::string& words = "{triangles}") const {
        return run("fuzz --fill top-left --scalar exact " + options + " -- " +
                   std::string(RASTERTRACE_DRIVEN) + " " + words);
    }
};

/// Mistakes from one number to another.
struct PlantedMistakes {
    int first;
    int last;
    std::string kind;     ///< of scenes that show them
    std::size_t vertices; ///< the fewest that do
    std::string ends;     ///< how the program is found to fail
};

const std::array<PlantedMistakes, 6> planted{{
    {1, 12, "2d", 3, "decides otherwise"},
    {13, 13, "2d", 3, "hangs"},
    {14, 14, "2d", 3, "does not end well"},
    {15, 18, "depth", 3, "decides otherwise"},
    {19, 19, "lines", 1, "decides otherwise"},
    {20, 20, "lines", 2, "decides otherwise"},
}};

TEST_F(FuzzTest, FindsEachOfTwentyMistakesAndShrinksIt) {
    for (const auto& [first, last, kind, vertices, ends] : planted)
        for (int mistake = first; mistake <= last; ++mistake) {
            const bool has_depth = kind == "depth";
            const Outcome told =
                fuzz(fmt::format("--runs 1000 --time 1 --kinds {}{}", kind,
                                 has_depth ? " --depth linear-z" : ""),
                     fmt::format("{{triangles}} {}{}", mistake, has_depth ? " depth" : ""));
            SCOPED_TRACE(fmt::format("mistake {}\n{}{}", mistake, told.out, told.err));
            EXPECT_EQ(told.status, 1);
            EXPECT_THAT(told.out, ContainsRegex("^seed [0-9]+: .* " + ends));
            std::smatch found;
            ASSERT_TRUE(std::regex_search(
                told.out, found,
                std::regex(R"(shrunk by \d+ runs? to (\d+) (?:triangle|line)s?, (\d+) vert)")));
            EXPECT_LE(std::stoul(found[2]), vertices + 3);

            // What is written fails as long as the program has the mistake, and says no more of it.
            const std::string script = "PATH=$(dirname $rastertrace):$PATH; sh fuzz/seed-*.sh";
            const Outcome failing = shell(script);
            EXPECT_NE(failing.status, 0) << failing.out;
            if (ends == "decides otherwise") {
                EXPECT_EQ(failing.status, 1) << failing.out << failing.err;
            }
            shell(fmt::format(R"(sed -i 's/ {}\( depth\)\? > / 0\1 > /' fuzz/seed-*.sh)", mistake));
            EXPECT_THAT(shell(script), Ends(0)) << shell("cat fuzz/*.sh").out;
            shell("rm -r fuzz");
        }
}

TEST_F(FuzzTest, ARasterizerWithoutMistakesPasses) {
    for (const std::string kind : {"2d", "lines", "depth"})
        EXPECT_THAT(
            fuzz(fmt::format("--runs {} --kinds {}{}", random_cases(700), kind,
                             kind == "depth" ? " --depth linear-z" : ""),
                 kind == "depth" ? "{triangles} 0 depth" : "{triangles}"),
            Prints(fmt::format("{0} runs, seeds 1 to {0}: no difference\ncompared: only the fields "
                               "that both traces have, of pixel, primitive\n",
                               random_cases(700))));
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
    write("rows.sh", std::string(RASTERTRACE_DRIVEN) + " $1 $2 > mine.jsonl; " +
                         std::string(RASTERTRACE_PROGRAM) + " show mine.jsonl --bare > \"$3\"\n");
    const auto with = [&](const std::string& mistake) {
        return run("fuzz --runs 60 --jobs 1 --shrink 40 --fill top-left --scalar exact -- sh "
                   "rows.sh {triangles} " +
                   mistake + " {out}");
    };
    EXPECT_EQ(with("0").status, 0) << with("0").out;
    EXPECT_THAT(with("11"), Ends(1, AllOf(HasSubstr("decides otherwise"), HasSubstr("pixel ("),
                                          HasSubstr("the pictures: "))));
}

// A picture that is drawn nearly all over, and the options that the written test needs.
TEST_F(FuzzTest, PicturesWithColorsAndTheOptionsOfTheTest) {
    write("ppm.sh", std::string(RASTERTRACE_DRIVEN) + " $1 $2 > mine.jsonl; " +
                        "set -- $(head -n 1 $1); echo P2 $2 $3 1 > mine.pgm; " +
                        std::string(RASTERTRACE_PROGRAM) +
                        " show mine.jsonl --bare | tr '.#' '01' | sed 's/./& /g' >> mine.pgm; "
                        "cat mine.pgm\n");
    const auto with = [&](const std::string& options, const std::string& mistake) {
        return run("fuzz --runs 60 --jobs 1 --shrink 40 --fill top-left --scalar exact " + options +
                   " -- sh ppm.sh {triangles} " + mistake);
    };
    EXPECT_EQ(with("", "0").status, 0) << with("", "0").out;
    EXPECT_EQ(with("", "11").status, 1);
    EXPECT_THAT(fuzz("--only pixel --tolerance 2ulp -o found", "{triangles} 3"), Ends(1));
    EXPECT_THAT(shell("cat found/*.sh").out, HasSubstr("--only pixel"));
    EXPECT_THAT(shell("cat found/*.sh").out, HasSubstr("--tolerance 2ulp"));
}

// What a child leaves is opened without waiting; its time counts wherever it is waited for.
TEST_F(FuzzTest, AChildCannotLetItWaitForEver) {
    const auto told = [&](const std::string& script) {
        return run("fuzz --runs 1 --shrink 0 --time 1 -- sh -c '" + script + "' {triangles} {out}")
            .out;
    };
    EXPECT_THAT(told("mkfifo $1"),
                HasSubstr("its {out}: expected a file, found a pipe or a device"));
    EXPECT_THAT(told("ln -s /dev/zero $1"),
                HasSubstr("its {out}: expected a file, found a pipe or"));
    EXPECT_THAT(told("mkdir -p $1/a; chmod 0 $1"),
                HasSubstr("its {out}: expected a file, found a folder"));
    EXPECT_THAT(told("true"), HasSubstr("it has not written its {out}"));
    EXPECT_THAT(told("exec >&- 2>&-; sleep 1000"), HasSubstr("hangs\nnot done after 1 s"));
    EXPECT_THAT(told("trap \"\" TERM; sleep 1000 & sleep 1000"), HasSubstr("hangs"));
    EXPECT_THAT(told("sleep 987 >/dev/null 2>&1 & true"), HasSubstr("it has not written"));
    EXPECT_EQ(shell("pgrep -fx 'sleep 987'").out, "") << "it was in the child's group";
}

TEST_F(FuzzTest, ASignalEndsTheWholeGroupAndLeavesNothing) {
    shell("mkdir temporary");
    for (const std::string signal :
         {"INT", "TERM", "HUP", "QUIT", "ABRT", "ALRM", "USR1", "PIPE", "XCPU"}) {
        const Outcome told = shell(
            "export TMPDIR=$PWD/temporary; ulimit -c 0; mkfifo begun; "
            "env --default-signal=" +
            signal +
            " $rastertrace fuzz --jobs 3 -- sh -c "
            "'sleep 976 & mkfifo $1; echo >begun; sleep 976' {triangles} {out} & "
            "read line <begun; kill -" +
            signal +
            " $!; wait $!; echo $?; rm begun; ls temporary; sleep 0.2; pgrep -fx 'sleep 976'");
        EXPECT_EQ(told.out, shell("sh -c 'ulimit -c 0; kill -" + signal + " $$'; echo $?").out)
            << signal;
        shell("rm -rf temporary/* fuzz");
    }
}

// Of pictures, too, colors are compared, and with them which triangle is in front; what is not compared is said.
TEST_F(FuzzTest, PicturesOfTrianglesAreComparedWithTheirColors) {
    const auto with = [&](const std::string& how, const std::string& options = "--depth linear-z") {
        return fuzz("--runs 300 --kinds depth --shrink 100 " + options, "{triangles} " + how);
    };
    EXPECT_THAT(with("0 depth rgb"), Prints("300 runs, seeds 1 to 300: no difference\n"));
    const Outcome exchanged = with("0 depth bgr");
    EXPECT_THAT(exchanged, Ends(1, HasSubstr("drawn in another color")));
    const Outcome without_test = with("0 none rgb");
    EXPECT_THAT(without_test, Ends(1, HasSubstr("drawn in another color")));
    EXPECT_THAT(
        with("0 none white"),
        Prints("300 runs, seeds 1 to 300: no difference\n"
               "compared: what is drawn, without colors\n"
               "its pictures have one color for all primitives: which of them is in front was "
               "not compared\n"));
}

// Numbers that are too short fail: floats beside long edges, 16 bits along long lines.
TEST_F(FuzzTest, ReachesWhatNumbersThatAreTooShortGetWrong) {
    for (const auto& [kind, number, type] :
         {std::tuple("2d", 21, "floats"), std::tuple("lines", 22, "16 bits")}) {
        const Outcome told = fuzz(fmt::format("--runs 1000 --shrink 0 --kinds {}", kind),
                                  fmt::format("{{triangles}} {}", number));
        EXPECT_THAT(told, Ends(1, HasSubstr("decides otherwise"))) << type;
    }
}

// A tie of depths is no mistake of a renderer whose numbers round: 16 lets the later of two equal depths win.
TEST_F(FuzzTest, ATieOfDepthsIsToldAsOne) {
    const Outcome told = fuzz("--runs 1000 --kinds depth --depth linear-z", "{triangles} 16 depth");
    EXPECT_THAT(told, Ends(1, HasSubstr("decides otherwise, where two depths are equal: a tie")));
    EXPECT_THAT(fuzz("--runs 1000 --kinds depth --depth linear-z", "{triangles} 15 depth").out,
                Not(HasSubstr("a tie")));
}

// Scenes in every text, of every kind: ours is a program that agrees with us.
TEST_F(FuzzTest, OurProgramAgreesWithItself) {
    write("fill.json", R"({"fill": "barycentric"})");
    for (const std::string options :
         {"--kinds 2d,lines,depth,clip -- $rastertrace trace --full {scene}",
          "--kinds clip --convention direct3d -- $rastertrace trace --full {scene}",
          "--kinds 2d,clip -- $rastertrace trace --full {triangles}",
          "--kinds 2d,lines --line dda -- $rastertrace trace --line dda --full {triangles}",
          "--kinds 2d,depth --keep depth,clip -- $rastertrace trace --full {scene}",
          "--kinds depth --full --depth inverse-z -- $rastertrace trace {scene}",
          "--kinds depth --method fill.json --fill top-left -- $rastertrace trace --full {scene}"})
        EXPECT_THAT(run("fuzz --runs 40 " + options), Ends(0)) << options;
}

// T2 shares no pixel: our trace does not test it, and one that tests whatever is drawn is right, too.
TEST_F(FuzzTest, ADepthTestThatTheSceneDoesNotNeedIsNoDifference) {
    EXPECT_THAT(run("fuzz --seed 14 --runs 1 --kinds depth --depth inverse-z -- $rastertrace trace "
                    "--full {scene}"),
                Ends(0));
    write("scene.txt", "canvas 4 1\ntri T1 0 1 0 0 0 0 0 2 0\ntri T2 3 1 1 4 0 1 3 0 1\n");
    const std::string depth = " scene.txt --depth linear-z ";
    EXPECT_NE(run("trace" + depth).out, run("trace --full" + depth).out);
    shell("$rastertrace trace --full" + depth +
          R"(| sed 's/"stages":\[[^]]*\],//' > theirs.jsonl)");
    EXPECT_THAT(run("diff --common --ignore header" + depth + "theirs.jsonl"),
                Prints(EndsWith("the same\n")));
    EXPECT_THAT(run("diff --common --ignore header theirs.jsonl" + depth),
                Prints(EndsWith("the same\n")));
}

TEST_F(FuzzTest, AKeptStageIsKeptInTheScene) {
    const Outcome apart = run("diagnose --tell-apart rounding=truncate asked --keep depth,clip");
    EXPECT_THAT(apart, Prints(HasSubstr(R"("keep": ["depth", "clip"])")));
    write("apart.json", apart.out);
    EXPECT_NE(run("show --bare apart.json").out,
              run("show --bare apart.json --rounding truncate").out);
}

// The text that is written is read by every command.
TEST_F(FuzzTest, TheTextOfTrianglesIsAScene) {
    fuzz("-o found --kinds 2d", "{triangles} 11");
    fuzz("-o found --kinds lines", "{triangles} 20");
    EXPECT_THAT(
        shell("for f in found/*.txt; do $rastertrace diff --fill top-left --scalar exact --ignore "
              "header,primitive.color,pixel.color,primitive.vertices,edge,scanline.left_edge,"
              "scanline.right_edge --common ${f%.txt}.golden.jsonl $f || exit; done"),
        Ends(0));
    for (const auto& [text, problem] :
         {std::pair("canvas 4 4\ntri A 0 0 0 1 x 0 1 0 0\n",
                    "bad.txt:2:15: expected a number, found \"x\""),
          std::pair("canvas 4 4\ntri A 0 0 0 1 0\n", "expected a name and 9 numbers behind tri"),
          std::pair("canvas 4\n", "bad.txt:1:9: expected 2 words behind canvas, found 1")}) {
        write("bad.txt", text);
        EXPECT_THAT(run("show bad.txt").err, HasSubstr(problem));
    }
}

TEST_F(FuzzTest, BadInput) {
    for (const auto& [words, problem] :
         {std::pair("-- true", "expected a program behind --"),
          std::pair("-- ./nothing {scene}", "could not be run"),
          std::pair("--kinds 3d -- true {scene}", "--kinds: expected"),
          std::pair("--runs 0 -- true {scene}", "--runs: expected a whole number from 1"),
          std::pair("-- true {scene} {triangles}", "expected one text of the scene")})
        EXPECT_THAT(shell(std::string("$rastertrace fuzz ") + words).err, HasSubstr(problem));
    EXPECT_EQ(run("fuzz -- true").status, 2);
    EXPECT_THAT(run("fuzz -- true {scene}"), Ends(1, StartsWith("seed 1: true gives no answer")));
    EXPECT_THAT(run("fuzz -- sh -c 'echo no triangle >&2; exit 7' {scene}").out,
                HasSubstr("exit status 7: no triangle"));
}

} // namespace
} // namespace rastertrace
