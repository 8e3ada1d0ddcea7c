// SPDX-License-Identifier: MIT
// Exercises are as much work as the scene that they are like, and tell slips apart.

#include <rastertrace/trace/check/exercise.h>
#include <rastertrace/trace/scene/scene_file.h>
#include <rastertrace/trace/text/input.h>

#include "effort.h"
#include "exercise_scenes.h"
#include "traces.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <array>
#include <cstdlib>
#include <set>
#include <string>

namespace rastertrace {
namespace {

using testing::HasSubstr;

Source example(const std::string& name) {
    return read_source(std::string(RASTERTRACE_EXAMPLES "/") + name, {}).value();
}

Scene exact_scene(const Source& source) {
    return read_scene(source, {{"scalar", "exact"}}).value().scene;
}

constexpr std::array templates{"t0-fill/first-triangle.json", "t2-lines/octants.json",
                               "tutorial/hidden/from-3-to-5.json",
                               "tutorial/filling/whose-slip.json"};

/// Draws an exercise, with a place on the canvas for each vertex, and looks at its numbers.
void expect_alike(const Scene& scene, const Scene& like) {
    ASSERT_EQ(scene.vertices.size(), like.vertices.size());
    for (std::size_t i = 0; i < scene.vertices.size(); ++i) {
        const SceneVertex& vertex = scene.vertices[i];
        for (const Rational& coordinate : {vertex.x.exact(), vertex.y.exact(), vertex.z.exact()})
            EXPECT_LE(coordinate.get_den(), 8);
        EXPECT_GE(vertex.x.exact(), scene.canvas.left());
        EXPECT_LE(vertex.x.exact(), scene.canvas.right());
        for (std::size_t k = 0; k < i; ++k) { // what was equal, above or below stays so
            const auto order = [](const Number& a, const Number& b) {
                return cmp(a.exact(), b.exact());
            };
            EXPECT_EQ(order(vertex.x, scene.vertices[k].x) > 0,
                      order(like.vertices[i].x, like.vertices[k].x) > 0);
            EXPECT_EQ(order(vertex.y, scene.vertices[k].y) == 0,
                      order(like.vertices[i].y, like.vertices[k].y) == 0);
        }
    }
}

TEST(Exercise, HasTheFactsOfTheSceneThatItIsLike) {
    for (const char* const name : templates) {
        const Source like = example(name);
        const Scene scene_like = exact_scene(like);
        const auto facts = exercise_facts(trace_of(scene_like));
        const ExerciseMaker exercise = exercises_like(like);
        std::set<std::string> texts;
        const int seeds = random_cases(20);
        for (int seed = 0; seed < seeds; ++seed) {
            const Source made = exercise("1:" + std::to_string(seed));
            SCOPED_TRACE(made.text);
            const Scene scene = exact_scene(made);
            EXPECT_EQ(exercise_facts(trace_of(scene)), facts);
            expect_alike(scene, scene_like);
            EXPECT_NE(made.text, like.text);
            texts.insert(made.text);
        }
        EXPECT_GT(texts.size() * 2, static_cast<std::size_t>(seeds)) << name;
    }
}

/// How many seeds are tried of each kind; RASTERTRACE_EXERCISE_SEEDS=1000 takes minutes.
int seeds_of_a_kind() {
    const char* const asked = std::getenv("RASTERTRACE_EXERCISE_SEEDS");
    return asked ? std::stoi(asked) : random_cases(10);
}

TEST(Exercise, ThereIsOneOfEachKindForEverySeed) {
    for (const ExerciseScene& kind : exercise_scenes) {
        const Source like{std::string(kind.name) + ".json", std::string(kind.text)};
        const auto facts = exercise_facts(trace_of(exact_scene(like)));
        const ExerciseMaker exercise = exercises_like(like);
        for (int seed = 0; seed < seeds_of_a_kind(); ++seed) {
            const Source made = exercise("1:" + std::to_string(seed));
            SCOPED_TRACE(made.text);
            const Scene scene = exact_scene(made);
            EXPECT_EQ(exercise_facts(trace_of(scene)), facts);
            if (scene.projection.type == ProjectionType::none)
                expect_alike(scene, exact_scene(like));
            std::set<std::string> answers;
            for (const auto& answer : slip_answers_in(trace_of(scene)))
                if (answer)
                    answers.insert(*answer);
            EXPECT_GT(answers.size(), 5U) << kind.name;
        }
    }
}

TEST(Exercise, IsTheSameForTheSameSeed) {
    const Source like = example(templates[0]);
    const std::string anna = exercises_like(like)("1:anna").text;
    EXPECT_EQ(anna, R"({"title": "First triangle",
 "canvas": {"width": 17, "height": 14},
 "vertices": {"A": [-1, 4], "B": [-4, -4], "C": [5, -4]},
 "triangles": ["ABC"],
 "method": {"scalar": "exact"}}
)");
    const ExerciseMaker exercise = exercises_like(like);
    EXPECT_NE(exercise("1:ben").text, anna);
    EXPECT_EQ(exercise("1:anna").text, anna); // whatever was made before
}

TEST(Exercise, AnIdIsAWordOfAKnownVersion) {
    EXPECT_EQ(exercise_id("anna").value(), "1:anna");
    EXPECT_EQ(exercise_id("1:anna").value(), "1:anna");
    for (const std::string odd : {"2:anna", "a:b", "1:", "", "a\nb", "anna,", "anna "})
        EXPECT_THAT(exercise_id(odd).problem().message,
                    HasSubstr("with version 1 before it, as 1:anna; found \""))
            << odd;
    EXPECT_FALSE(exercise_id(std::string(10'000, 'a')));
}

TEST(Exercise, ASheetNamesItAlsoAfterASpreadsheet) {
    const auto id_in = [](const std::string& text) {
        return exercise_of_sheet({"sheet.csv", text}).value();
    };
    EXPECT_EQ(id_in("\xEF\xBB\xBF# exercise 1:Lee, Anna;;;;\r\ny;left\r\n"), "1:Lee, Anna");
    EXPECT_EQ(id_in("scene: a.json\n# exercise anna\n"), "1:anna");
    EXPECT_EQ(id_in("y=2: 1, 2 # exercise 1:anna\n"), "");
    EXPECT_THAT(exercise_of_sheet({"sheet.csv", "# exercise 3:anna\n"}).problem().message,
                HasSubstr("found \"3:anna\""));
}

TEST(Exercise, ASceneWhoseFactsNoOtherNumbersHaveIsRefused) {
    const Source scene{"point.json", R"({"canvas": {"width": 1, "height": 1},
        "vertices": {"A": [0, 0]}, "points": ["A"]})"};
    try {
        exercises_like(scene);
        ADD_FAILURE() << "no Problem";
    } catch (const Problem& problem) {
        EXPECT_THAT(problem.message,
                    HasSubstr("expected a scene whose facts other numbers can have"));
    }
}

} // namespace
} // namespace rastertrace
