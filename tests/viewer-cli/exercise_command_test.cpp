// SPDX-License-Identifier: MIT
// `rastertrace exercise` and `check --class` as a teacher and a grader meet them.

#include "program.h"

#include <rastertrace/trace/check/derivation.h>
#include <rastertrace/trace/check/slips.h>
#include <rastertrace/trace/check/step_index.h>
#include <rastertrace/trace/exercise/exercise.h>
#include <rastertrace/trace/exercise/exercise_kinds.h>
#include <rastertrace/trace/record/traced_steps.h>
#include <rastertrace/trace/scene/scene_file.h>
#include <rastertrace/trace/text/text.h>

#include <fmt/core.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <iostream>
#include <map>
#include <set>
#include <string>
#include <vector>

namespace rastertrace {
namespace {

using nlohmann::json;
using testing::AllOf;
using testing::ContainsRegex;
using testing::HasSubstr;
using testing::Not;
using testing::StartsWith;

/// The numbers as a claim has them: one, or a list.
json as_claimed(const Values& values, FieldType type, bool is_list) {
    json all = json::array();
    for (const Rational& value : values)
        all.push_back(type == FieldType::whole ? json(value.get_num().get_si())
                                               : json(value.get_str()));
    return is_list ? all : all.at(0);
}

/// The sheet of a student who makes a slip wherever it can be made, and everything else rightly.
std::string sheet_with(const Slip& slip, const Source& scene) {
    const auto read = read_scene(scene, {{"scalar", "exact"}});
    const Trace trace = drawn_trace(read.value().scene, read.value().plan, "scene.json", 20'000);
    const StepIndex index(trace);
    const Numbers numbers(index);
    json claims = json::array();
    std::set<std::size_t> lines;
    for (std::size_t n = 1; n <= trace.size(); ++n) {
        const StepKind kind = *trace.kind_of(n);
        const bool has_part = index.primitive_of(n) != 0;
        json claim{{"step", name_of(kind)}};
        const json step = json::parse(trace.step(n).json());
        if (has_part && kind != StepKind::vertex && kind != StepKind::face &&
            kind != StepKind::light)
            claim["in"] = trace.step(index.primitive_of(n)).as<PrimitiveStep>().name.text();
        // All decisions of a line are one claim.
        if (kind == StepKind::decide && !lines.insert(index.primitive_of(n)).second)
            continue;
        bool is_claimed = false;
        for (const StepField& field : fields_of(kind)) {
            const json told = step.value(std::string(field.name), json());
            if (field.role == FieldRole::key && kind != StepKind::decide && !told.is_null())
                claim[std::string(field.name)] = told;
            const bool is_number =
                field.element == FieldType::quantity || field.element == FieldType::whole;
            if (!is_number || field.role == FieldRole::key || told.is_null())
                continue;
            const auto formulas = formulas_of(numbers, n, field.name);
            if (formulas.empty())
                continue;
            const auto slipped = slip.redo(formulas.front());
            const Values values =
                slipped.empty() ? value_of(formulas.front()) : slipped.back().values;
            claim[std::string(field.name)] = as_claimed(
                values, field.element, kind == StepKind::decide || field.type == FieldType::list);
            is_claimed = true;
        }
        if (is_claimed)
            claims.push_back(claim);
    }
    return json{{"scene", "scene.json"}, {"claims", claims}}.dump();
}

class ExerciseTest : public ProgramTest {};

TEST_F(ExerciseTest, OfThirtyStudentsWhoMakeOneMistakeEachItIsNamedFirst) {
    constexpr std::size_t students = 30;
    std::vector<std::vector<std::string_view>> planted; // and what is the same as that
    for (std::size_t i = 0; i < students; ++i) {
        const ExerciseKind& kind = exercise_kinds[i % exercise_kinds.size()];
        ExerciseMaker maker({std::string(kind.name), std::string(kind.scene)});
        const Exercise made = maker.exercise("1:" + std::to_string(i));
        planted.push_back(made.slips[(i * 5) % made.slips.size()]);
        const std::string folder =
            std::string("class/") + static_cast<char>('A' + i % 26) + std::to_string(i / 26);
        fs::create_directories(folder_ / folder);
        write(folder + "/scene.json", made.scene.text);
        write(folder + "/sheet.json", sheet_with(*find_slip(planted.back().front()), made.scene));
    }
    const Outcome marked = shell("$rastertrace check --class class --format csv");
    EXPECT_EQ(marked.status, 1) << marked.err;
    std::map<std::string, std::string> first; // of each sheet
    for (std::string line : split_at(marked.out, '\n')) {
        while (line.ends_with('\r'))
            line.pop_back();
        first[line.substr(0, line.find(','))] = line.substr(line.rfind(',') + 1);
    }
    std::size_t named = 0;
    for (std::size_t i = 0; i < students; ++i) {
        const std::string sheet =
            static_cast<char>('A' + i % 26) + std::to_string(i / 26) + "/sheet.json";
        const bool is_named = std::ranges::find(planted[i], first[sheet]) != planted[i].end();
        named += is_named ? 1 : 0;
        if (!is_named)
            std::cout << sheet << ": planted " << planted[i].front() << ", named " << first[sheet]
                      << "\n";
    }
    EXPECT_GE(named, 28U);
}

TEST_F(ExerciseTest, TheGraderNeedsOnlyTheSeed) {
    ASSERT_EQ(shell("$rastertrace exercise --kind scanline --seed anna -o anna").status, 0);
    EXPECT_EQ(shell("$rastertrace exercise --kind scanline --seed anna").out,
              content("anna/scene.json"));
    EXPECT_THAT(content("anna/sheet.txt"), StartsWith("# exercise 1:anna\n"));
    EXPECT_THAT(content("anna/picture.svg"), StartsWith("<svg"));
    EXPECT_THAT(
        content("anna/picture.svg"),
        AllOf(HasSubstr("exercise 1:anna"), HasSubstr("method: fill scanline, rounding floor")));
    const Outcome marked = shell("$rastertrace exercise --kind scanline --seed 1:anna | "
                                 "$rastertrace check - anna/sheet.txt");
    EXPECT_EQ(marked.status, 0);
    EXPECT_THAT(marked.out, StartsWith("0 right, 0 wrong, "));
}

// What is to be worked out with must be on the sheet, and nothing of what is to be worked out.
TEST_F(ExerciseTest, ThePrintedSheetHasAllThatTheSceneGives) {
    ASSERT_EQ(shell("$rastertrace exercise --kind depth --seed a -o depth; "
                    "$rastertrace exercise --kind clip --seed a -o clip; "
                    "$rastertrace exercise --kind light --seed a -o light")
                  .status,
              0);
    EXPECT_THAT(content("depth/picture.svg"), ContainsRegex(R"(A \([^,]*, [^,]*, [^,]*\))"));
    EXPECT_THAT(content("clip/picture.svg"),
                HasSubstr("projection: {type: view-plane, distance: 1, near: 1}"));
    EXPECT_THAT(content("clip/picture.svg"), Not(HasSubstr("ABC:1 (")));
    EXPECT_THAT(content("light/picture.svg"), HasSubstr("light: {direction: [1, 2, 3]}"));
}

TEST_F(ExerciseTest, AClassHasAFolderForEachSeed) {
    const Outcome made =
        shell("$rastertrace exercise --kind bresenham --seed class --count 3 -o .");
    EXPECT_EQ(made.status, 0) << made.err;
    EXPECT_THAT(made.out, HasSubstr("written: ./class-3\n"));
    EXPECT_NE(content("class-1/scene.json"), content("class-2/scene.json"));
    EXPECT_EQ(shell("$rastertrace exercise --kind bresenham --seed class-2").out,
              content("class-2/scene.json"));
}

/// The commands in the fences of a page that are to be run one after the other.
std::vector<std::string> scripts_in(const std::string& page) {
    std::vector<std::string> scripts;
    const std::string fence = "```sh\n";
    for (std::size_t at = page.find(fence); at != std::string::npos; at = page.find(fence, at)) {
        at += fence.size();
        scripts.push_back(page.substr(at, page.find("```\n", at) - at));
    }
    return scripts;
}

TEST_F(ExerciseTest, TheCommandsOfThePageForTeachersRun) {
    // The program by its name, and the folders of courses' machines in this one.
    write("rastertrace", "#!/bin/sh\nexec '" RASTERTRACE_PROGRAM "' \"$@\"\n");
    ASSERT_EQ(shell("chmod +x rastertrace; cp $examples/t0-fill/first-triangle.json scene.json; "
                    "mkdir -p autograder/source autograder/submission autograder/results "
                    "grade/tests grade/student; "
                    "cp scene.json autograder/source; cp scene.json grade/tests")
                  .status,
              0);
    write("names.txt", "Anna Lee\nben\n");
    write("autograder/submission_metadata.json",
          R"({"id": 7, "users": [{"email": "a@b", "id": 9, "sid": "4711", "name": "Anna"}]})");
    const Outcome sheet = shell("$rastertrace exercise --like scene.json --seed 4711 -o 4711 && "
                                "cp 4711/sheet.txt autograder/submission && "
                                "cp 4711/sheet.txt grade/student");
    ASSERT_EQ(sheet.status, 0) << sheet.err;

    std::ostringstream page;
    page << std::ifstream(RASTERTRACE_EXAMPLES "/../docs/for-teachers.md").rdbuf();
    const auto scripts = scripts_in(page.str());
    ASSERT_GE(scripts.size(), 6U);
    for (std::string script : scripts) {
        for (const std::string folder : {" /autograder", " /grade"})
            for (std::size_t at = script.find(folder); at != std::string::npos;
                 at = script.find(folder))
                script.erase(at + 1, 1);
        const Outcome run = shell("PATH=.:$PATH; set -e\n" + script);
        EXPECT_EQ(run.status, 0) << script << run.err;
        EXPECT_EQ(run.err, "") << script;
    }
    EXPECT_THAT(content("named/Anna Lee/sheet.txt"), StartsWith("# exercise 1:Anna Lee\n"));
    EXPECT_THAT(content("marks.csv"), HasSubstr("2026-30/sheet.txt,0,0,0,12,,1:2026-30"));
    EXPECT_EQ(json::parse(content("autograder/results/results.json")).at("tests").size(), 12U);
    EXPECT_EQ(json::parse(content("grade/results/results.json")).at("score"), 0);
    EXPECT_THAT(content("results.xml"), HasSubstr("tests=\"12\""));
}

TEST_F(ExerciseTest, MarksAreAPointForEachClaimThatIsRightOrFollowsRightly) {
    const std::string claims = "$examples/claims/first-steps.claims";
    const Outcome marked =
        shell("$rastertrace check " + claims + " --format gradescope --visibility hidden");
    EXPECT_EQ(marked.status, 1);
    std::string points;
    const json graded = json::parse(marked.out);
    for (const json& test : graded.at("tests")) {
        points += std::to_string(test.at("score").get<int>());
        EXPECT_EQ(test.at("visibility"), "hidden");
        EXPECT_EQ(test.at("status"), test.at("score") == 1 ? "passed" : "failed");
    }
    EXPECT_EQ(points, "1010101");
    const Outcome told =
        shell("$rastertrace check " + claims + " --format prairielearn --no-answers");
    const json results = json::parse(told.out);
    EXPECT_NEAR(results.at("score").get<double>(), 4.0 / 7, 1e-12);
    EXPECT_EQ(results.at("tests").at(2).at("message"), "follows"); // as its point says
    EXPECT_EQ(results.at("tests").at(1).at("output"), "");
    EXPECT_THAT(shell("$rastertrace check " + claims + " --format markdown").out,
                HasSubstr("| 9 | y=2: -1/4, 25/8 -> 0..3 | wrong |\n"));

    write("garbled.txt", "scene: scene.json\ny=2: 1/4\n");
    const Outcome garbled = shell("$rastertrace check garbled.txt --format gradescope");
    EXPECT_EQ(garbled.status, 2);
    EXPECT_EQ(json::parse(garbled.out).at("score"), 0);
    EXPECT_EQ(json::parse(shell("$rastertrace check garbled.txt --format prairielearn").out)
                  .at("gradable"),
              false);
}

// What was left out is open; what nobody asked for, or asked for once, is no point.
TEST_F(ExerciseTest, AnExerciseIsMarkedByItsWholeSheet) {
    ASSERT_EQ(shell("$rastertrace exercise --kind scanline --seed anna -o anna").status, 0);
    const std::string sheet = content("anna/sheet.txt");
    const std::size_t begin = sheet.find("edge");
    std::string first = sheet.substr(begin, sheet.find('?', begin) - begin); // "edge AB: "
    const auto mark = [&](const std::string& lines) {
        write("one.txt", "\xEF\xBB\xBF# exercise 1:anna\r\n" + lines);
        return shell("$rastertrace check --kind scanline one.txt --format csv").out;
    };
    const Outcome right = shell("$rastertrace trace anna/scene.json --only edge -o -");
    const std::size_t at = right.out.find("\"dx_dy\":\"");
    ASSERT_NE(at, std::string::npos) << right.err;
    const std::string slope = right.out.substr(at + 9, right.out.find('"', at + 9) - at - 9);
    const std::string line = first + slope + "\n";
    EXPECT_THAT(mark(line), HasSubstr("one.txt,1,0,0,11,,1:anna\r\n"));
    EXPECT_THAT(mark(line + line + "(8,5): off\n"), HasSubstr("one.txt,1,0,0,11,,1:anna\r\n"));
    EXPECT_THAT(mark(line + first + "77\n"), HasSubstr("one.txt,0,1,0,11,"));
    const json results =
        json::parse(shell("$rastertrace check --kind scanline one.txt --format gradescope").out);
    EXPECT_EQ(results.at("tests").size(), 12U);
}

TEST_F(ExerciseTest, AFilledInSheetIsNotWrittenOver) {
    const std::string make = "$rastertrace exercise --kind scanline --seed anna -o anna";
    ASSERT_EQ(shell(make + " && " + make).status, 0); // an empty one may be written again
    ASSERT_EQ(shell("echo 'edge AB: 1' >> anna/sheet.txt").status, 0);
    const std::string filled = content("anna/sheet.txt");
    const Outcome again = shell(make);
    EXPECT_EQ(again.status, 2);
    EXPECT_THAT(again.err, HasSubstr("expected no sheet that has been filled in, found one"));
    EXPECT_EQ(content("anna/sheet.txt"), filled);

    // The same of the sheet of any scene.
    const std::string sheet = "$rastertrace sheet $examples/t0-fill/first-triangle.json -o ";
    for (const std::string name : {"mine.txt", "mine.csv"}) {
        ASSERT_EQ(shell(sheet + name + " && " + sheet + name).status, 0);
        ASSERT_EQ(shell("echo 'y=4: 2, 2' >> " + name).status, 0);
        EXPECT_THAT(shell(sheet + name).err,
                    HasSubstr(name + ": expected no sheet that has been filled in, found one"));
    }
}

TEST_F(ExerciseTest, AClassMayHaveOtherFilesAndSheetsThatCannotBeRead) {
    ASSERT_EQ(
        shell("mkdir class; cp $examples/t0-fill/first-triangle.json class/scene.json; "
              "mkdir class/ben class/.git; printf %PDF > class/notes.pdf; : > class/empty.txt")
            .status,
        0);
    write("class/.git/anna.txt", "scene: ../scene.json\nedge AB: 3/4\n");
    write("class/anna.txt", "scene: scene.json\nedge AB: 3/4\n");
    write("class/ben/a.txt", "scene: ../scene.json\nedge AB: 4/3\n");
    write("class/ben/b.txt", "scene: ../scene.json\nedge AB: 3/4\n");
    write("class/cleo.txt", "edge AB: 3/4\n");
    const Outcome marked = shell("$rastertrace check --class class -o slips.svg");
    EXPECT_EQ(marked.status, 2);
    EXPECT_THAT(
        marked.err,
        HasSubstr("class: 2 sheets of ben: ben/a.txt, ben/b.txt; each of them is marked\n"));
    EXPECT_THAT(marked.err, HasSubstr("cleo.txt: expected a scene before the claims"));
    EXPECT_THAT(marked.err, HasSubstr("empty.txt: expected claims, found none"));
    EXPECT_THAT(marked.out, StartsWith("anna.txt: 1 right, 0 wrong\n"
                                       "ben/a.txt: 0 right, 1 wrong; most likely dx-dy-inverted\n"
                                       "ben/b.txt: 1 right, 0 wrong\n"
                                       "cleo.txt: could not be checked\n"
                                       "empty.txt: could not be checked\n\n"
                                       "5 sheets, 2 all right\n"));
    EXPECT_THAT(marked.out, HasSubstr("\ndx-dy-inverted  # 1  dx/dy = "));
    EXPECT_THAT(marked.out, HasSubstr("no sheets: notes.pdf, scene.json\n"));
    EXPECT_THAT(content("slips.svg"), HasSubstr("dx-dy-inverted"));
    // With the scene given, what sheets say of it does not matter.
    EXPECT_THAT(shell("$rastertrace check class/scene.json --class class").out,
                HasSubstr("cleo.txt: 1 right, 0 wrong\n"));

    EXPECT_EQ(shell("mkdir none; $rastertrace check --class none").status, 2);
    EXPECT_EQ(shell("$rastertrace check --class nowhere").status, 2);
    for (const char* const options :
         {"--format gradescope", "--hint 1", "--kind scanline class/scene.json", "-o slips.pdf"})
        EXPECT_EQ(shell(std::string("$rastertrace check --class class ") + options).status, 2)
            << options;
    EXPECT_THAT(shell("$rastertrace check").err,
                HasSubstr("expected a file of claims, or --class"));
}

TEST_F(ExerciseTest, ARemarkOnASceneIsToldOnceHoweverManySheetsThereAre) {
    ASSERT_EQ(shell("mkdir class").status, 0);
    write("class/scene.json", R"({"canvas": {"width": 9, "height": 9},
        "vertices": {"A": [0, 0], "B": [4, 3], "C": [2, 5, 5]}, "lines": [["A", "B"], ["B", "C"]]})");
    for (int i = 0; i < 20; ++i)
        write(fmt::format("class/{}.txt", i), "scene: scene.json\nedge AB: 3/4\n");
    for (const char* const scene : {"", "class/scene.json "}) {
        const std::string remarks =
            shell(fmt::format("$rastertrace check {}--class class", scene)).err;
        const std::size_t first = remarks.find("remark: ");
        ASSERT_NE(first, std::string::npos) << scene << remarks;
        EXPECT_EQ(remarks.find("remark: ", first + 1), std::string::npos) << scene << remarks;
    }
}

TEST_F(ExerciseTest, TwoSheetsOfOneExerciseAreTold) {
    ASSERT_EQ(shell("$rastertrace exercise --kind scanline --seed s --count 2 -o class; "
                    "cp class/s-1/sheet.txt class/s-2/sheet.txt; echo 'edge AB: 1' > class/x.txt")
                  .status,
              0);
    const Outcome marked = shell("$rastertrace check --class class --kind scanline");
    EXPECT_EQ(marked.status, 2);
    EXPECT_THAT(marked.err, HasSubstr("2 sheets of exercise 1:s-1: s-1/sheet.txt, s-2/sheet.txt"));
    EXPECT_THAT(marked.err, HasSubstr("x.txt: expected a line that names the exercise"));
}

TEST_F(ExerciseTest, MemoryDoesNotGrowWithTheClass) {
    const auto peak_of = [&](const std::string& count) {
        const Outcome marked =
            shell("rm -rf class; $rastertrace exercise --kind bresenham --seed s "
                  "--count " +
                  count +
                  " -o class > made && "
                  "$rastertrace check --class class --kind bresenham");
        EXPECT_EQ(marked.status, 0) << marked.err;
        return marked.peak_memory;
    };
    const long few = peak_of("10");
    EXPECT_LT(peak_of("60"), few + 8'000'000);
}

TEST_F(ExerciseTest, BadInputIsToldInPlainWords) {
    EXPECT_THAT(shell("$rastertrace exercise --seed anna").err, HasSubstr("[--like,--kind]"));
    EXPECT_THAT(shell("$rastertrace exercise --kind line --seed anna").err,
                HasSubstr("--kind: expected one out of scanline, bresenham, "));
    EXPECT_THAT(shell("$rastertrace exercise --kind scanline --seed 2:anna").err,
                HasSubstr("expected an ID of version 1, found one of version \"2\""));
    EXPECT_EQ(shell("$rastertrace exercise --kind scanline --seed anna --count 3").status, 2);

    EXPECT_THAT(shell("$rastertrace exercise --kind scanline --seed a/b --count 2 -o x").err,
                HasSubstr("--seed: expected no / beside --count"));
    EXPECT_THAT(shell("$rastertrace exercise --like $examples/t2-lines/points.json --seed a").err,
                HasSubstr("expected a scene with numbers to work out, found only pixels"));

    // Before anything is written.
    write("mesh.json", R"({"canvas": {"width": 16, "height": 12}, "triangles": ["ABC"],
        "vertices": {"A": [-6, -4, 0], "B": [5, -3, 1], "C": [0, 4, 3]},
        "meshes": [{"obj": "triangle.obj"}]})");
    write("triangle.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n");
    EXPECT_THAT(shell("$rastertrace exercise --like mesh.json --seed anna -o folder").err,
                HasSubstr("mesh.json: expected a scene of one file, found a mesh in another one"));
    EXPECT_FALSE(fs::exists(folder_ / "folder"));
}

} // namespace
} // namespace rastertrace
