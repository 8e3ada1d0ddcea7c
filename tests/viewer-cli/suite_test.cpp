// SPDX-License-Identifier: MIT
// `rastertrace suite`: a folder of scenes, traces and claims, in shards, resumed, and with a program that fails.

#include "program.h"

#include <fmt/core.h>
#include <gmock/gmock.h>
#include <nlohmann/json.hpp>

#include <array>
#include <map>
#include <string>
#include <utility>

namespace rastertrace {
namespace {

using ::testing::AllOf;
using ::testing::HasSubstr;
using ::testing::Not;

// The right triangle under y = 6 - x: 5 samples in the first row, 4 in the next, ...
const std::string triangle =
    R"({"canvas": {"width": 8, "height": 8, "origin": "top-left"},
"vertices": {"A": [0, 0], "B": [6, 0], "C": [0, 6]}, "triangles": ["ABC"],
"method": {"fill": "top-left", "scalar": "exact"}})";

class SuiteTest : public ProgramTest {
protected:
    /// A folder with a case of each kind, right and wrong.
    SuiteTest() {
        shell("mkdir -p s/deep s/deep/er");
        for (const std::string scene : {"alone", "golden", "deep/changed", "deep/cut", "deep/er/x"})
            write("s/" + scene + ".json", triangle);
        write("s/bad.json", R"({"canvas": {"width": 8, "height": 8}, "triangles": ["ABC"]})");
        write("s/package.json", R"({"name": "renderer"})");
        write("s/picture.txt", "canvas 1 1\n");
        write("s/right.claims", "scene: alone.json\n(4,0): on\n(5,0): off\n");
        write("s/deep/wrong.claims", "scene: ../alone.json\n(5,0): on\n");
        // Goldens, traces of others, and damaged ones, all of the same triangle.
        shell("cd s; t() { $rastertrace trace \"$@\"; }; t golden.json -o golden.golden.jsonl;"
              "t alone.json --fill scanline -o deep/changed.golden.jsonl;"
              "t alone.json --only pixel -o golden.mine.jsonl;"
              "sed '/\"x\":3,\"y\":0/d; s/\"steps\":15/\"steps\":14/' golden.mine.jsonl "
              "> deep/er/x.theirs.jsonl;"
              "head -n 5 golden.golden.jsonl | tee deep/cut.golden.jsonl > deep/er/cut.jsonl");
    }

    Outcome suite(const std::string& options) const {
        return shell("$rastertrace suite " + options);
    }

    /// The outcome of each case, in the JSON of a suite.
    static std::map<std::string, std::string> outcomes(const std::string& json) {
        std::map<std::string, std::string> found;
        const auto document = nlohmann::json::parse(json);
        for (const auto& one : document["cases"])
            found[one["name"]] = one["outcome"];
        return found;
    }
};

const std::map<std::string, std::string> expected_outcomes{{"alone.json", "passed"},
                                                           {"bad.json", "failed"},
                                                           {"deep/changed.json", "failed"},
                                                           {"deep/cut.json", "failed"},
                                                           {"deep/er/cut.jsonl", "failed"},
                                                           {"deep/er/x.json", "passed"},
                                                           {"deep/er/x.theirs.jsonl", "failed"},
                                                           {"deep/wrong.claims", "failed"},
                                                           {"golden.json", "passed"},
                                                           {"golden.mine.jsonl", "passed"},
                                                           {"package.json", "left out"},
                                                           {"right.claims", "passed"}};

TEST_F(SuiteTest, EachKindOfFileIsACase) {
    const Outcome json = suite("s --format json");
    EXPECT_EQ(json.status, 1) << json.err;
    EXPECT_EQ(outcomes(json.out), expected_outcomes);
    EXPECT_THAT(suite("s").out,
                AllOf(HasSubstr("deep/er/x.theirs.jsonl: 1 step differs, 1 pixel differs\n"),
                      HasSubstr("deep/cut.golden.jsonl:6:1: expected the rest of the trace"),
                      HasSubstr("s/deep/wrong.claims:2: (5,0): on\n"),
                      Not(HasSubstr("alone.json:")),
                      HasSubstr("6 of 11 cases failed; 1 file left out: ")));
    shell("cd s; rm -r deep bad.json");
    const Outcome fine = suite("s");
    EXPECT_EQ(fine.status, 0);
    EXPECT_EQ(fine.out, "0 of 4 cases failed; 1 file left out: no scene, trace or claims\n");
}

TEST_F(SuiteTest, RulesOfTheTeamAndOptionsCount) {
    write("s/deep/er/rastertrace-rules.json", R"({"ignore": ["pixel"]})");
    EXPECT_EQ(outcomes(suite("s --format json").out)["deep/er/x.theirs.jsonl"], "passed");
    EXPECT_EQ(outcomes(suite("s --format json --fill scanline").out)["golden.json"], "failed");
}

TEST_F(SuiteTest, TheSameBytesForAllJobsAndShards) {
    for (const std::string format : {"text", "json", "markdown", "junit"}) {
        const std::string whole = suite("s --jobs 1 --format " + format).out;
        EXPECT_EQ(suite("s --jobs 4 --format " + format).out, whole);
        for (const int shards : {1, 2, 5, 13}) // of 12 files: one shard is empty
            for (const int jobs : {1, 3}) {
                const Outcome merged = shell(fmt::format(
                    "for i in $(seq {0}); do $rastertrace suite s --jobs {1} --shard $i/{0} "
                    "--format json > r$i.json; done; "
                    "$rastertrace suite merge $(seq -f r%g.json {0} -1 1) --format {2}",
                    shards, jobs, format));
                EXPECT_EQ(merged.out, whole) << shards << " shards, " << jobs << " jobs";
                EXPECT_EQ(merged.status, 1) << merged.err;
            }
    }
}

TEST_F(SuiteTest, JUnitIsXml) {
    write("s/<&\">.json", "{\"canvas\": \"]]>\x01\"}");
    const std::string xml = suite("s --format junit > r.xml; python3 -c '"
                                  "import xml.dom.minidom as m; s = m.parse(\"r.xml\")"
                                  ".getElementsByTagName(\"testsuite\")[0]; "
                                  "print(s.getAttribute(\"tests\"), "
                                  "s.getAttribute(\"failures\"), "
                                  "len(s.getElementsByTagName(\"testcase\")), "
                                  "len(s.getElementsByTagName(\"failure\")), "
                                  "len(s.getElementsByTagName(\"skipped\")))'")
                                .out;
    EXPECT_EQ(xml, "13 7 13 7 1\n") << content("r.xml");
}

/// A program that draws as we do, and writes down what it draws. The fourth time, or the fifth, if two run at once, it
/// does something else.
std::string fourth_time(const std::string& what) {
    return "echo \"$1\" >> runs; if [ $(wc -l < runs) -ge 4 ] && mkdir once; then " + what +
           "; fi; " + std::string(RASTERTRACE_PROGRAM) + " trace \"$1\"\n";
}

TEST_F(SuiteTest, KilledAndResumedItSaysTheSame) {
    shell("for i in 1 2 3 4 5 6 7 8; do cp s/alone.json s/copy$i.json; done");
    const std::string with_program = " s --jobs 2 --resume journal -- sh mine.sh {scene}";
    write("mine.sh", fourth_time("true"));
    const std::string whole = suite(with_program).out;
    const std::string scenes = shell("sort runs").out;
    for (const std::string signal : {"KILL", "INT", "TERM"}) {
        SCOPED_TRACE(signal);
        shell("rm -r journal runs once");
        // One program for both runs: it decides by what it has written down.
        write("mine.sh", fourth_time("kill -" + signal + " $PPID; sleep 1"));
        EXPECT_GT(suite(with_program).status, 128);
        const Outcome resumed = suite(with_program);
        EXPECT_EQ(resumed.out, whole) << resumed.err;
        EXPECT_EQ(resumed.status, 1);
        // Only what ran when the signal came is run twice: at most one for each of the two jobs.
        const std::string all = shell("sort -u runs").out;
        EXPECT_EQ(all, scenes);
        EXPECT_LE(std::stoi(shell("wc -l < runs").out),
                  std::stoi(shell("sort -u runs | wc -l").out) + 2);
        shell("rm runs");
        EXPECT_EQ(suite(with_program).out, whole);
        EXPECT_EQ(content("runs"), "") << "everything is in the journal";
    }
}

TEST_F(SuiteTest, OfAJournalOnlyWhatHasChangedIsRunAgain) {
    const std::string first = suite("s --resume journal").out;
    const auto lines = [&] { return std::stoi(shell("wc -l < journal").out); };
    const int before = lines();
    EXPECT_EQ(suite("s --resume journal").out, first);
    EXPECT_EQ(lines(), before);
    // The scene of claims, which no name tells, and a golden; and a mesh, once it is there.
    shell("cp s/golden.golden.jsonl s/deep/changed.golden.jsonl");
    write("s/deep/wrong.claims", "scene: ../alone.json\n(5,0): off\n");
    const auto changed = outcomes(suite("s --resume journal --format json").out);
    EXPECT_EQ(changed.at("deep/changed.json"), "passed");
    EXPECT_EQ(changed.at("deep/wrong.claims"), "passed");
    EXPECT_EQ(lines(), before + 2);
    shell("sed -i 's/6, 0/4, 0/' s/alone.json"); // and its claims say (4,0): on
    const auto other = outcomes(suite("s --resume journal --format json").out);
    EXPECT_EQ(other.at("right.claims"), "failed");
    EXPECT_EQ(other.at("alone.json"), "passed");
    write("s/meshed.json",
          R"({"canvas": {"width": 4, "height": 4}, "meshes": [{"obj": "m.obj"}]})");
    EXPECT_EQ(outcomes(suite("s --resume journal --format json").out)["meshed.json"], "failed");
    write("s/m.obj", "v 0 0 1\nv 2 0 1\nv 0 2 1\nf 1 2 3\n");
    EXPECT_EQ(outcomes(suite("s --resume journal --format json").out)["meshed.json"], "passed");
    // Another method is another question.
    EXPECT_EQ(
        outcomes(suite("s --resume journal --format json --fill scanline").out)["golden.json"],
        "failed");
}

TEST_F(SuiteTest, GoesOnWhenTheProgramFails) {
    shell("rm -r s/deep s/bad.json s/*.claims s/golden.mine.jsonl s/package.json");
    write("s/hang.json", triangle);
    write("s/silent.json", triangle);
    write("mine.sh",
          "case $1 in *hang*) sleep 60;; *alone*) kill -SEGV $$;; *silent*) exit 0;; esac; " +
              std::string(RASTERTRACE_PROGRAM) + " trace $1\n");
    const Outcome told = suite("s --time 1 -- sh mine.sh {scene}");
    EXPECT_EQ(told.status, 1);
    EXPECT_EQ(told.out,
              "alone.json: does not end well: ended by signal 11\n\n"
              "hang.json: hangs: not done after 1 s\n\n"
              "silent.json: gives no answer: expected a trace or a picture, found neither\n\n"
              "3 of 4 cases failed\n");
    // What it draws is held against the golden; without one, against our drawing; by a picture, too.
    shell("rm s/hang.json s/silent.json");
    EXPECT_EQ(suite("s -- $rastertrace trace {scene}").status, 0);
    EXPECT_EQ(suite("s -- $rastertrace show --last --bare {scene}").status, 0);
    EXPECT_THAT(suite("s -- $rastertrace show --last --bare --fill scanline {scene}").out,
                AllOf(HasSubstr("alone.json: decides otherwise"),
                      HasSubstr("golden.json: decides otherwise")));
}

TEST_F(SuiteTest, AFullDiskLeavesAJournalThatCanBeUsed) {
    const std::string whole = suite("s").out;
    EXPECT_EQ(suite("s > /dev/full").status, 3);
    for (const int blocks : {1, 2, 3}) { // of 512 bytes
        SCOPED_TRACE(blocks);
        const Outcome full =
            shell(fmt::format("rm -f journal; ulimit -f {}; $rastertrace suite s --jobs 2 --resume "
                              "journal",
                              blocks));
        EXPECT_EQ(full.status, 3);
        EXPECT_THAT(full.err,
                    AllOf(HasSubstr("rastertrace: journal: could not be written: File too "
                                    "large\n"),
                          HasSubstr("hint: the cases before are kept there")));
        const std::string kept = content("journal");
        EXPECT_TRUE(kept.empty() || kept.back() == '\n');
        EXPECT_EQ(suite("s --resume journal").out, whole);
        EXPECT_TRUE(content("journal").starts_with(kept));
    }
    // Cut in the middle of a line, as by a machine that went down.
    const std::string all = content("journal");
    for (const std::size_t size :
         {std::size_t(0), std::size_t(7), all.size() / 2, all.size() - 1}) {
        write("journal", all.substr(0, size));
        EXPECT_EQ(suite("s --resume journal").out, whole) << size;
    }
}

TEST_F(SuiteTest, BadInput) {
    shell("mkdir empty; $rastertrace suite s --shard 1/3 --format json > 1.json; "
          "$rastertrace suite s --shard 2/2 --format json > other.json");
    write("notes", "to do\n");
    for (const auto& [words, problem] :
         {std::pair("s --shard 0/2", "--shard: expected I/N with I from 1 to N, found \"0/2\""),
          std::pair("s --shard 3/2", "found \"3/2\""), std::pair("s --shard 2", "found \"2\""),
          std::pair("s --jobs 0", "--jobs: expected a whole number from 1"),
          std::pair("s --format csv", "--format: expected one of text, json, markdown, junit"),
          std::pair("empty", "empty: expected scenes, traces or claims, found none"),
          std::pair("nothing", "nothing: expected a folder of cases"),
          std::pair("s t", "suite: expected one folder, or merge"),
          std::pair("merge", "suite: expected one folder, or merge"),
          std::pair("merge 1.json", "expected each shard of one suite once, found 1/3"),
          std::pair("merge 1.json 1.json 1.json", "found 1/3, 1/3, 1/3"),
          std::pair("merge 1.json other.json", "found 1/3, 2/2"),
          std::pair("merge s/alone.json", "s/alone.json:1:1: expected what `suite --format json`"),
          std::pair("merge notes", "notes:1:1: expected"),
          std::pair("s --resume notes", "notes: expected a journal of `suite`, found another file"),
          std::pair("s --resume /dev/null", "/dev/null: expected a file to keep a journal in"),
          std::pair("s -- true", "suite: expected a program behind --, with {scene}"),
          std::pair("s -- true {triangles}",
                    "suite: expected a program behind --, with {scene}")}) {
        const Outcome told = suite(words);
        EXPECT_EQ(told.status, 2) << words;
        EXPECT_THAT(told.err, HasSubstr(problem)) << words;
    }
    EXPECT_EQ(content("notes"), "to do\n");
    EXPECT_EQ(suite("s -- ./nothing {scene}").status, 3);
    // Two runs must not write into one journal.
    write("wait.sh", "echo > begun; while [ ! -e done ]; do sleep 0.01; done\n");
    EXPECT_THAT(shell("$rastertrace suite s --resume j -- sh wait.sh {scene} & "
                      "while [ ! -e begun ]; do sleep 0.01; done; "
                      "$rastertrace suite s --resume j; echo $? >&2; touch done; wait")
                    .err,
                AllOf(HasSubstr("found one in use"), HasSubstr("\n2\n")));
}

} // namespace
} // namespace rastertrace
