// SPDX-License-Identifier: MIT
// Exercises are as much work as the scene that they are like, and tell slips apart.

#include <rastertrace/trace/exercise/exercise.h>
#include <rastertrace/trace/exercise/exercise_id.h>
#include <rastertrace/trace/exercise/exercise_kinds.h>
#include <rastertrace/trace/exercise/facts.h>
#include <rastertrace/trace/scene/scene_file.h>
#include <rastertrace/trace/text/input.h>

#include "effort.h"
#include "traces.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
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
        const auto facts = facts_of(trace_of(scene_like));
        ExerciseMaker maker(like);
        std::set<std::string> texts;
        const int seeds = random_cases(20);
        for (int seed = 0; seed < seeds; ++seed) {
            const Exercise made = maker.exercise("1:" + std::to_string(seed));
            SCOPED_TRACE(made.scene.text);
            const Scene scene = exact_scene(made.scene);
            EXPECT_EQ(facts_of(trace_of(scene)), facts);
            expect_alike(scene, scene_like);
            EXPECT_NE(made.scene.text, like.text);
            texts.insert(made.scene.text);
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
    for (const ExerciseKind& kind : exercise_kinds) {
        const Source like{std::string(kind.name) + ".json", std::string(kind.scene)};
        const auto facts = facts_of(trace_of(exact_scene(like)));
        ExerciseMaker maker(like);
        for (int seed = 0; seed < seeds_of_a_kind(); ++seed) {
            const Exercise made = maker.exercise("1:" + std::to_string(seed));
            SCOPED_TRACE(made.scene.text);
            const Scene scene = exact_scene(made.scene);
            EXPECT_EQ(facts_of(trace_of(scene)), facts);
            if (scene.projection.type == ProjectionType::none)
                expect_alike(scene, exact_scene(like));
            EXPECT_GT(made.slips.size(), 5U) << kind.name;
        }
    }
}

TEST(Exercise, IsTheSameForTheSameSeed) {
    const Source like = example(templates[0]);
    const std::string anna = ExerciseMaker(like).exercise("1:anna").scene.text;
    ExerciseMaker maker(like);
    EXPECT_NE(maker.exercise("1:ben").scene.text, anna);
    EXPECT_EQ(maker.exercise("1:anna").scene.text, anna); // whatever was made before
}

TEST(Exercise, AnIdIsAWordOfAKnownVersion) {
    EXPECT_EQ(exercise_id("anna").value(), "1:anna");
    EXPECT_EQ(exercise_id("1:anna").value(), "1:anna");
    EXPECT_THAT(exercise_id("2:anna").problem().message, HasSubstr("found one of version \"2\""));
    EXPECT_THAT(exercise_id(std::string(10'000, 'a')).problem().message, HasSubstr("found 10000"));
    EXPECT_THAT(exercise_id("a\nb").problem().message, HasSubstr("control characters"));
    EXPECT_FALSE(exercise_id(""));
}

TEST(Exercise, ASceneWhoseFactsNoOtherNumbersHaveIsRefused) {
    const Source scene{"point.json", R"({"canvas": {"width": 1, "height": 1},
        "vertices": {"A": [0, 0]}, "points": ["A"]})"};
    try {
        ExerciseMaker maker(scene);
        ADD_FAILURE() << "no Problem";
    } catch (const Problem& problem) {
        EXPECT_THAT(problem.message,
                    HasSubstr("expected a scene whose facts other numbers can have"));
    }
}

} // namespace
} // namespace rastertrace
