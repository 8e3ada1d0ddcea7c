// SPDX-License-Identifier: MIT
// `rastertrace diff FOLDER FOLDER`: the files of both, by name.

#include "program.h"

#include <nlohmann/json.hpp>

#include <string>

namespace rastertrace {
namespace {

class DiffFoldersTest : public ProgramTest {
protected:
    /// Two folders with the same three traces, one of them in a folder below, and a page that is none.
    DiffFoldersTest() {
        shell(
            "mkdir -p a/deep && cd a && $rastertrace trace $examples/t2-lines/tie.json -o tie.json;"
            "$rastertrace trace $examples/t0-fill/first-triangle.json -o first.jsonl;"
            "cp first.jsonl deep; echo text > page.md; cp page.md .hidden.json; cd ..; cp -r a b");
    }

    /// Lets a trace of b begin a row one pixel later, in the way of a cast instead of `floor`.
    void change(const std::string& file) const {
        run("trace $examples/t0-fill/first-triangle.json --rounding truncate -o b/" + file);
    }
};

TEST_F(DiffFoldersTest, EqualFoldersHaveNoDifference) {
    EXPECT_THAT(diff("a b"), Prints("3 compared, 0 differ\n"));
    EXPECT_EQ(diff("a/ a").out, "3 compared, 0 differ\n");
    EXPECT_EQ(diff("a b --language pt").out, "3 comparados, 0 diferem\n");
    EXPECT_EQ(diff("a b --json").out, "{\"compared\":3,\"differ\":0,\"unread\":0,\"files\":[]}\n");
}

TEST_F(DiffFoldersTest, TheFirstDifferenceIsToldBelowTheNameOfItsFile) {
    change("deep/first.jsonl");
    EXPECT_THAT(
        diff("a b --ignore header"),
        Ends(1, "deep/first.jsonl: 8 steps differ, 4 pixels differ\n"
                "    a: a/deep/first.jsonl\n"
                "    b: b/deep/first.jsonl\n"
                "    8 steps differ\n"
                "\n"
                "    the first difference, in ABC\n"
                "    a   step 13 (line 14): pixel (2, 3)   row y=3: 0 to 2\n"
                "    a > step 14 (line 15): scanline y=2   left AB: x = 2 + 3/4 (2 - 5) = -1/4 -> "
                "floor -> -1   right AC: x = 2 - 3/8 (2 - 5) = 25/8 -> floor -> 3\n"
                "    a   step 15 (line 16): pixel (-1, 2)   row y=2: -1 to 3\n"
                "    b   step 13 (line 14): pixel (2, 3)   row y=3: 0 to 2\n"
                "    b > step 14 (line 15): scanline y=2   left AB: x = 2 + 3/4 (2 - 5) = -1/4 -> "
                "truncate -> 0   right AC: x = 2 - 3/8 (2 - 5) = 25/8 -> truncate -> 3\n"
                "    b   step 15 (line 16): pixel (0, 2)   row y=2: 0 to 3\n"
                "        from: -1 in a, 0 in b, 1 apart\n"
                "        1 pixel differs because of it\n"
                "            only in a: (-1, 2)\n"
                "\n"
                "3 compared, 1 differs\n"));
    change("first.jsonl");
    EXPECT_THAT(diff("a b").out, HasSubstr("\n3 compared, 2 differ\n"));
}

TEST_F(DiffFoldersTest, OptionsAreThoseOfEachPair) {
    change("first.jsonl");
    EXPECT_EQ(diff("a b --ignore header").status, 1);
    EXPECT_EQ(diff("a b --ignore header --only primitive").status, 0);
    EXPECT_EQ(diff("a b --ignore header,pixel --tolerance scanline.from=1").status, 0);
    EXPECT_EQ(diff("a b --ignore pixl").status, 2);
    EXPECT_THAT(diff("a b --color always").out, HasSubstr("\x1b["));
    // Scenes are drawn, by the method that is asked for.
    shell("rm -r a b; mkdir a b; cp $examples/t0-fill/first-triangle.json a/first.json;"
          "$rastertrace trace a/first.json -o b/first.json");
    EXPECT_EQ(diff("a b").status, 0);
    EXPECT_EQ(diff("a b --rounding truncate").status, 1);
}

TEST_F(DiffFoldersTest, AFileOfOneSideIsADifference) {
    shell("rm a/tie.json b/deep/first.jsonl");
    EXPECT_THAT(diff("a b"), Ends(1, "deep/first.jsonl: only in a\n"
                                     "tie.json: only in b\n"
                                     "3 compared, 2 differ\n"));
}

TEST_F(DiffFoldersTest, WithoutFilesOfOneNameNothingIsCompared) {
    shell("mkdir none; mkdir page; cp a/page.md page; mkdir other; cp a/tie.json other/knot.json");
    for (const std::string folders : {"none none", "a none", "none a", "page page", "a other"})
        EXPECT_THAT(diff(folders), Ends(2, "",
                                        "rastertrace: diff: nothing to compare: the folders have "
                                        "no file of one name\nhint: compared are files that end in "
                                        ".json, .jsonl, .png, .ppm, .pgm, .pbm, .tga\n"))
            << folders;
    EXPECT_EQ(diff("a missing").err, "rastertrace: missing: expected a folder of traces, found "
                                     "that it cannot be read: No such file or directory\n");
    EXPECT_EQ(diff("a a/tie.json").status, 2);
    EXPECT_EQ(diff("a/tie.json a").err, "rastertrace: a: expected a file, found a folder\n");
}

TEST_F(DiffFoldersTest, OtherFilesAreComparedAlthoughOneCannotBeRead) {
    change("first.jsonl");
    shell("head -c 1000 a/tie.json > b/tie.json; echo nothing > b/deep/first.jsonl");
    EXPECT_THAT(
        diff("a b"),
        Ends(2,
             AllOf(HasSubstr("deep/first.jsonl: cannot be read\n"),
                   HasSubstr("tie.json: cannot be read\n"), HasSubstr("first.jsonl: 8 steps"),
                   HasSubstr("\n3 compared, 1 differs, 2 cannot be read\n")),
             AllOf(HasSubstr("rastertrace: b/deep/first.jsonl:1:1: "),
                   HasSubstr("rastertrace: b/tie.json:"), HasSubstr("truncated"))));
}

TEST_F(DiffFoldersTest, ALinkThatLeadsToNothingIsToldAndTheOthersAreCompared) {
    shell("for f in a b; do ln -s loop.json $f/loop.json; ln -s gone.json $f/gone.json; done");
    EXPECT_THAT(diff("a b"),
                Ends(2,
                     AllOf(HasSubstr("loop.json: cannot be read\n"),
                           HasSubstr("\n5 compared, 0 differ, 2 cannot be read\n")),
                     AllOf(HasSubstr("Too many levels of symbolic links"),
                           HasSubstr("a/gone.json: expected a file that can be read"))));
}

TEST_F(DiffFoldersTest, JsonHasTheSame) {
    change("first.jsonl");
    shell("rm b/deep/first.jsonl; echo nothing > b/tie.json");
    const auto told = nlohmann::json::parse(diff("a b --json").out);
    EXPECT_EQ(told["compared"], 3);
    EXPECT_EQ(told["differ"], 2);
    EXPECT_EQ(told["unread"], 1);
    EXPECT_EQ(told["files"][0], nlohmann::json({{"name", "deep/first.jsonl"}, {"only", "a"}}));
    EXPECT_EQ(told["files"][1]["name"], "first.jsonl");
    EXPECT_EQ(told["files"][1]["diff"],
              nlohmann::json::parse(diff("a/first.jsonl b/first.jsonl --json").out));
    EXPECT_EQ(told["files"][2]["name"], "tie.json");
    EXPECT_THAT(told["files"][2]["problem"], HasSubstr("b/tie.json:1:1: "));
}

TEST_F(DiffFoldersTest, PicturesAreComparedToo) {
    shell("rm -r a b; mkdir a b; $rastertrace figure $examples/t0-fill/first-triangle.json --bare "
          "-o a/first.png; cp a/first.png b");
    EXPECT_EQ(diff("a b").out, "1 compared, 0 differ\n");
    run("figure $examples/t0-fill/first-triangle.json --bare --rounding truncate -o b/first.png");
    EXPECT_THAT(diff("a b"),
                Ends(1, AllOf(HasSubstr("first.png: "), Not(HasSubstr("cannot be read")),
                              HasSubstr("\n1 compared, 1 differs\n"))));
}

} // namespace
} // namespace rastertrace
