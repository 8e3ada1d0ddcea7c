// SPDX-License-Identifier: MIT
// `rastertrace sheet`, and what a teacher and a grader do with sheets that have a seed.

#include "exercise_scenes.h"
#include "program.h"

#include <rastertrace/trace/check/exercise.h>
#include <rastertrace/trace/check/slips.h>
#include <rastertrace/trace/check/step_index.h>
#include <rastertrace/trace/record/traced_steps.h>
#include <rastertrace/trace/scene/scene_file.h>
#include <rastertrace/trace/tell/formulas_of.h>
#include <rastertrace/trace/text/text.h>

#include <fmt/core.h>
#include <nlohmann/json.hpp>

#include <iostream>
#include <map>
#include <set>
#include <string>
#include <vector>

namespace rastertrace {
namespace {

using nlohmann::json;

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
    const Numbers& numbers = index.right();
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

class SheetTest : public ProgramTest {
protected:
    SheetTest() {
        for (const ExerciseScene& scene : exercise_scenes)
            write(std::string(scene.name) + ".json", std::string(scene.text));
    }
};

TEST_F(SheetTest, OfThirtyStudentsWhoMakeOneMistakeEachItIsNamedFirst) {
    constexpr std::size_t students = 30;
    std::vector<std::set<std::string_view>> planted; // and what is the same as that
    for (std::size_t i = 0; i < students; ++i) {
        const ExerciseScene& like = exercise_scenes[i % exercise_scenes.size()];
        const Source made = exercises_like({std::string(like.name), std::string(like.text)})(
            "1:" + std::to_string(i));
        const auto read = read_scene(made, {{"scalar", "exact"}});
        const Answers answers = slip_answers_in(
            drawn_trace(read.value().scene, read.value().plan, "scene.json", 20'000));
        std::map<std::string, std::set<std::string_view>> slips_with; // an answer
        for (std::size_t slip = 0; slip < answers.size(); ++slip)
            if (answers[slip])
                slips_with[*answers[slip]].insert(slips()[slip].name);
        planted.push_back(
            std::next(slips_with.begin(), static_cast<std::ptrdiff_t>((i * 5) % slips_with.size()))
                ->second);
        const std::string folder = fmt::format("class/{:02}", i);
        fs::create_directories(folder_ / folder);
        write(folder + "/scene.json", made.text);
        write(folder + "/sheet.json", sheet_with(*find_slip(*planted.back().begin()), made));
    }
    const Outcome marked = run("check class/*/sheet.json");
    EXPECT_EQ(marked.status, 1) << marked.err;
    const auto lines = split_at(marked.out, '\n');
    std::size_t named = 0;
    for (std::size_t i = 0; i < students; ++i) {
        EXPECT_THAT(lines[i], StartsWith(fmt::format("class/{:02}/sheet.json: ", i)));
        const bool is_named = planted[i].contains(lines[i].substr(lines[i].rfind(' ') + 1));
        named += is_named ? 1 : 0;
        if (!is_named)
            std::cout << "planted " << *planted[i].begin() << ": " << lines[i] << "\n";
    }
    EXPECT_GE(named, 28U);
    EXPECT_THAT(marked.out,
                HasSubstr("\nThe most likely slip of a sheet, and of how many sheets:\n"));
}

// What is to be worked out with must be on the sheet, and nothing of what is to be worked out.
TEST_F(SheetTest, WithASeedHasAllThatTheSceneGives) {
    EXPECT_THAT(run("sheet scanline.json --seed anna").out,
                StartsWith("# exercise 1:anna\n"
                           "# a relative name is looked for from the folder of this file\n"
                           "scene: scanline.json\n"
                           "# title: The rows of a triangle\n"
                           "# canvas: {width: 17, height: 14}\n"
                           "# vertices: {A: [-1, 4], B: [-4, -4], C: [5, -4]}\n"
                           "# triangles: [ABC]\n"
                           "# method: fill scanline, rounding floor"));
    EXPECT_THAT(run("sheet depth.json --seed a").out,
                ContainsRegex(R"(# vertices: \{A: \[[^,]*, [^,]*, [^,]*\])"));
    EXPECT_THAT(run("sheet clip.json --seed a").out,
                AllOf(HasSubstr("\n# projection: {type: view-plane, distance: 1, near: 1}\n"),
                      Not(HasSubstr("ABC:1 ("))));
    EXPECT_THAT(run("sheet light.json --seed a").out,
                HasSubstr("\n# light: {direction: [1, 2, 3]}\n"));
    EXPECT_THAT(
        run("sheet scanline.json").out,
        AllOf(HasSubstr("scene: scanline.json\n\nedge AB: ?\n"), Not(HasSubstr("vertices"))));
}

TEST_F(SheetTest, WithASeedIsCheckedAgainstItsExercise) {
    ASSERT_EQ(shell("mkdir out; for name in a c; do "
                    "$rastertrace sheet scanline.json --seed $name -o out/$name.txt && "
                    "$rastertrace sheet scanline.json --seed $name --format csv > out/$name.csv || "
                    "exit; done")
                  .status,
              0);
    EXPECT_NE(content("out/a.txt"), content("out/c.txt"));
    EXPECT_THAT(content("out/a.csv"), StartsWith("# exercise 1:a\n# title: "));
    // The slope of AB in a, which is another one in c.
    write("redrawn.json", exercises_like({"scanline.json", content("scanline.json")})("1:a").text);
    const Outcome told = run("show redrawn.json --every edge --format csv");
    const std::size_t at = told.out.find("AB,");
    ASSERT_NE(at, std::string::npos) << told.out;
    const std::string slope =
        told.out.substr(at + 3, told.out.find_first_of(",\r\n", at + 3) - at - 3);
    const Outcome marked = shell("cd out; for name in a c; do "
                                 "sed -i 's|^edge AB: .*|edge AB: " +
                                 slope + "|' $name.txt; sed -i 's|^AB,.*|AB," + slope +
                                 "|' $name.csv; done; "
                                 "$rastertrace check ../scanline.json a.txt a.csv c.txt c.csv");
    EXPECT_EQ(marked.status, 1) << marked.err;
    EXPECT_THAT(marked.out, AllOf(StartsWith("a.txt (exercise 1:a): 1 right, 0 wrong, 11 open\n"
                                             "a.csv (exercise 1:a): 1 right, 0 wrong, 11 open\n"
                                             "c.txt (exercise 1:c): 0 right, 1 wrong, 11 open"),
                                  HasSubstr("\nc.csv (exercise 1:c): 0 right, 1 wrong, 11 open")));
    // By the name of the scene in the sheet; of a trace, by the trace.
    EXPECT_EQ(shell("sed -i 's|scanline.json|../scanline.json|' out/a.txt; "
                    "$rastertrace check out/a.txt")
                  .out,
              "1 right, 0 wrong, 11 open\n");
    EXPECT_EQ(run("trace redrawn.json | $rastertrace check - out/a.txt").status, 0);
    const json one = json::parse(run("check scanline.json out/a.txt --json").out);
    EXPECT_EQ(one.at("exercise"), "1:a");
    EXPECT_EQ(one.at("open"), 11);
    EXPECT_FALSE(
        json::parse(run("check $examples/claims/t0-rows.claims --json").out).contains("exercise"));
}

/// The commands, or the programs, in the fences of a page.
std::vector<std::string> scripts_in(const std::string& page, const std::string& fence) {
    std::vector<std::string> scripts;
    for (std::size_t at = page.find(fence); at != std::string::npos; at = page.find(fence, at)) {
        at += fence.size();
        scripts.push_back(page.substr(at, page.find("```\n", at) - at));
    }
    return scripts;
}

TEST_F(SheetTest, TheCommandsAndProgramsOfThePageForTeachersRun) {
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
    std::ostringstream page;
    page << std::ifstream(RASTERTRACE_EXAMPLES "/../docs/for-teachers.md").rdbuf();
    const auto commands = scripts_in(page.str(), "```sh\n");
    ASSERT_EQ(commands.size(), 3U);
    for (const std::string& script : commands)
        EXPECT_THAT(shell("PATH=.:$PATH; set -e\n" + script), Ends(0, _, "")) << script;
    EXPECT_THAT(content("named/Anna Lee.csv"), StartsWith("# exercise 1:Anna Lee\n"));
    const json marks = json::parse(content("marks.json"));
    EXPECT_EQ(marks.size(), 30U);
    EXPECT_EQ(marks.at(0).at("exercise"), "1:2026-1");
    EXPECT_EQ(marks.at(0).at("open"), 12);

    const auto grades = [&](const std::string& change) {
        EXPECT_THAT(run("sheet scene.json --seed 4711 | " + change +
                        " > autograder/submission/sheet.txt; cp autograder/submission/sheet.txt "
                        "grade/student"),
                    Ends(0));
        const auto programs = scripts_in(page.str(), "```python\n");
        EXPECT_EQ(programs.size(), 2U);
        for (std::string program : programs) {
            for (const std::string folder : {"\"/autograder", "\"/grade"})
                for (std::size_t at = program.find(folder); at != std::string::npos;
                     at = program.find(folder))
                    program.erase(at + 1, 1);
            write("grader.py", program);
            EXPECT_THAT(shell("PATH=.:$PATH; python3 grader.py"), Ends(0));
        }
        return std::pair(json::parse(content("autograder/results/results.json")),
                         json::parse(content("grade/results/results.json")));
    };
    const auto [empty, empty_too] = grades("cat");
    EXPECT_EQ(empty.at("tests").size(), 12U);
    EXPECT_EQ(empty.at("score"), 0);
    EXPECT_EQ(empty_too.at("score"), 0);
    // BC is horizontal; the rest was left out, or is wrong.
    const auto [marked, marked_too] = grades("sed '/^y=/d; s/^edge AB: ?/edge AB: 77/'");
    EXPECT_EQ(marked.at("tests").at(0).at("status"), "failed");
    EXPECT_EQ(marked.at("tests").at(0).at("output"), "how far an edge goes in x for one row");
    EXPECT_EQ(marked_too.at("tests").at(0).at("points"), 0);
    const auto [other, other_too] = grades("sed s/1:4711/1:4712/");
    EXPECT_EQ(other.at("output"), "This is not the sheet of 4711.");
    const auto [garbled, garbled_too] = grades("sed '$ a y=2: x'");
    for (const json& results : {garbled, garbled_too})
        EXPECT_THAT(results.at("tests").back().at("output").get<std::string>(),
                    HasSubstr("sheet.txt:"));
}

// What was left out is open; what nobody asked for, or asked for once, is no point.
TEST_F(SheetTest, OfAnExerciseIsCountedByTheEmptySheet) {
    const std::string sheet = run("sheet scanline.json --seed anna").out;
    const std::size_t begin = sheet.find("edge");
    const std::string first = sheet.substr(begin, sheet.find('?', begin) - begin); // "edge AB: "
    const auto mark = [&](const std::string& lines) {
        write("one.txt", "\xEF\xBB\xBF# exercise 1:anna\r\n" + lines);
        const std::string told = run("check scanline.json one.txt").out;
        return told.substr(told.rfind('\n', told.size() - 2) + 1); // the last line
    };
    // A is (-1, 4), B (-4, -4).
    const std::string line = first + "3/8\n";
    EXPECT_EQ(mark(line), "1 right, 0 wrong, 11 open\n");
    EXPECT_EQ(mark(line + line + "(8,5): off\n"), "1 right, 0 wrong, 11 open\n");
    EXPECT_EQ(mark(line + first + "77\n"), "0 right, 1 wrong, 11 open\n");
}

TEST_F(SheetTest, AFilledInSheetIsNotWrittenOver) {
    for (const std::string sheet : {"", "--seed anna "})
        for (const std::string name : {"mine.txt", "mine.csv"}) {
            const std::string make = "$rastertrace sheet scanline.json " + sheet + "-o " + name;
            ASSERT_EQ(shell("rm -f " + name + "; " + make + " && " + make).status, 0);
            ASSERT_EQ(shell("echo 'y=4: 2, 2' >> " + name).status, 0);
            const std::string filled = content(name);
            EXPECT_THAT(shell(make),
                        Refused(HasSubstr(
                            name + ": expected no sheet that has been filled in, found one")));
            EXPECT_EQ(content(name), filled);
        }
}

TEST_F(SheetTest, ARemarkOnASceneIsToldOnceHoweverManySheetsThereAre) {
    write("scene.json", R"({"canvas": {"width": 9, "height": 9},
        "vertices": {"A": [0, 0], "B": [4, 3], "C": [2, 5, 5]}, "lines": [["A", "B"], ["B", "C"]]})");
    for (int i = 0; i < 20; ++i)
        write(fmt::format("{}.txt", i), "scene: scene.json\nedge AB: 3/4\n");
    for (const char* const scene : {"", "scene.json "}) {
        const std::string remarks = shell(fmt::format("$rastertrace check {}*.txt", scene)).err;
        const std::size_t first = remarks.find("remark: ");
        ASSERT_NE(first, std::string::npos) << scene << remarks;
        EXPECT_EQ(remarks.find("remark: ", first + 1), std::string::npos) << scene << remarks;
    }
}

TEST_F(SheetTest, MemoryDoesNotGrowWithTheClass) {
    const auto peak_of = [&](const std::string& count) {
        const Outcome marked =
            shell("rm -rf class; mkdir class; for i in $(seq " + count +
                  "); do $rastertrace sheet bresenham.json --seed s-$i -o class/$i.txt || exit; "
                  "done; $rastertrace check bresenham.json class/*.txt");
        EXPECT_EQ(marked.status, 0) << marked.err;
        return marked.peak_memory;
    };
    const long few = peak_of("10");
    EXPECT_LT(peak_of("60"), few + 8'000'000);
}

TEST_F(SheetTest, BadInputIsToldInPlainWords) {
    EXPECT_THAT(run("sheet scanline.json --seed 2:anna").err,
                HasSubstr("perhaps with version 1 before it, as 1:anna; found \"2:anna\""));
    EXPECT_THAT(run("sheet $examples/t2-lines/points.json --seed a").err,
                HasSubstr("expected a scene with numbers to work out, found only pixels"));
    EXPECT_THAT(run("trace scanline.json | $rastertrace sheet - --seed a").err,
                HasSubstr("--seed: expected a scene, found a trace"));
    EXPECT_THAT(run("sheet scanline.json -o sheet.svg").err,
                HasSubstr("expected a name that ends in .txt or .csv, found .svg"));

    // Before anything is written.
    write("mesh.json", R"({"canvas": {"width": 16, "height": 12}, "triangles": ["ABC"],
        "vertices": {"A": [-6, -4, 0], "B": [5, -3, 1], "C": [0, 4, 3]},
        "meshes": [{"obj": "triangle.obj"}]})");
    write("triangle.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n");
    EXPECT_THAT(run("sheet mesh.json --seed anna -o sheet.txt").err,
                HasSubstr("mesh.json: expected a scene of one file, found a mesh in another one"));
    EXPECT_FALSE(fs::exists(folder_ / "sheet.txt"));
}

} // namespace
} // namespace rastertrace
