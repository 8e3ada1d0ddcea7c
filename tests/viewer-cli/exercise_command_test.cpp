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
using testing::HasSubstr;
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
            const Values values = slipped.empty() ? value_of(formulas.front()) : slipped[0].values;
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
    const Outcome marked = shell("$rastertrace exercise --kind scanline --seed 1:anna | "
                                 "$rastertrace check - anna/sheet.txt");
    EXPECT_EQ(marked.status, 0);
    EXPECT_THAT(marked.out, StartsWith("0 right, 0 wrong, "));
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

TEST_F(ExerciseTest, BadInputIsToldInPlainWords) {
    EXPECT_THAT(shell("$rastertrace exercise --seed anna").err, HasSubstr("[--like,--kind]"));
    EXPECT_THAT(shell("$rastertrace exercise --kind line --seed anna").err,
                HasSubstr("--kind: expected one out of scanline, bresenham, "));
    EXPECT_THAT(shell("$rastertrace exercise --kind scanline --seed 2:anna").err,
                HasSubstr("expected an ID of version 1, found one of version \"2\""));
    EXPECT_EQ(shell("$rastertrace exercise --kind scanline --seed anna --count 3").status, 2);
}

} // namespace
} // namespace rastertrace
