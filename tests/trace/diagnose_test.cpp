// SPDX-License-Identifier: MIT
// Which rule accounts for what was drawn: each known mistake is found again in what it draws, and none in what is right.

#include <rastertrace/core/draw/draw.h>
#include <rastertrace/trace/diagnose/diagnosis.h>
#include <rastertrace/trace/diagnose/tell_apart.h>
#include <rastertrace/trace/fuzz/fuzz_scene.h>
#include <rastertrace/trace/text/conventions.h>

#include "effort.h"
#include "random_scene.h"
#include "traces.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <random>
#include <string>
#include <vector>

namespace rastertrace {
namespace {

SeenCells cells(const Image& image) {
    return {image.canvas().width,
            image.canvas().height,
            {image.colors().begin(), image.colors().end()}};
}

bool are_alike(const Image& a, const Image& b) {
    return std::ranges::equal(a.colors(), b.colors());
}

/// Random scenes that the model draws: in the plane with every fill, in space with cameras, lights and colors.
std::string scene_text_of(std::uint64_t seed) {
    constexpr std::array kinds{FuzzKind::plane, FuzzKind::lines, FuzzKind::depth, FuzzKind::clip};
    const std::vector<MethodOverrides> methods{{},
                                               {{"fill", "top-left"}},
                                               {{"rounding", "half-open"}, {"rows", "half-open"}},
                                               {{"line", "naive"}}};
    if (seed % 2 == 0)
        return RandomScene(seed).text();
    return scene_json(random_scene(seed, {.kinds = {kinds[seed / 2 % kinds.size()]},
                                          .method = methods[seed / 8 % methods.size()],
                                          .largest_canvas = 64}));
}

Diagnosis diagnosis_of(const std::string& scene, const Image& drawn, DiagnoseOptions options = {}) {
    const DrawnPair pair{{"scene.json", scene}, cells(drawn)};
    return diagnose({&pair, 1}, options);
}

/// True if a mistake, or the setting that draws as it does, is in the answer.
bool has(const Diagnosis& found, const Mistake& mistake) {
    return std::ranges::any_of(found.answer, [&](const AnsweredRule& one) {
        return std::ranges::find(one.rule.mistakes, &mistake) != one.rule.mistakes.end() ||
               std::ranges::find(one.same, &mistake) != one.same.end();
    });
}

/// True if the answer is a mistake, and not a convention.
bool names_mistake(const Diagnosis& found) {
    return !found.answer.empty() && !found.answer.front().rule.mistakes.empty();
}

TEST(Diagnose, FindsEachMistakeInWhatItDraws) {
    const int scenes =
        random_cases(20) / 10; // for each mistake; scripts/check-diagnose.sh takes 200
    int all = 0;
    int named = 0;
    int short_answers = 0;
    for (const Mistake& mistake : mistakes()) {
        int left = scenes;
        // Other scenes for each.
        const auto first = static_cast<std::uint64_t>(&mistake - mistakes().data()) * 97 + 1;
        for (std::uint64_t seed = first; left > 0 && seed < first + 400; ++seed) {
            const std::string text = scene_text_of(seed);
            const auto read = read_scene({"scene.json", text}, {{"scalar", "exact"}});
            if (!read || !has_model(read.value().scene) || !mistake.concerns(read.value().scene))
                continue;
            const Source scene{"scene.json", text};
            const auto drawn = drawn_by({{}, {&mistake}}, scene);
            if (!drawn || are_alike(*drawn, *drawn_by({}, scene)))
                continue;
            --left;
            const Diagnosis found = diagnosis_of(text, *drawn);
            ++all;
            EXPECT_EQ(found.unexplained, 0U) << mistake.name << "\n" << text;
            named += has(found, mistake);
            short_answers += found.answer.size() <= 3;
            if (!has(found, mistake))
                std::cout << mistake.name << " is not among the answers, of which the first is "
                          << name_of(found.answer.front().rule) << "\n"
                          << text << "\n";
        }
        if (left == scenes)
            std::cout << "no scene shows " << mistake.name << "\n";
    }
    EXPECT_GE(named * 100, all * 99) << named << " of " << all;
    EXPECT_GE(short_answers * 100, all * 85) << short_answers << " of " << all;
}

TEST(Diagnose, NamesNoMistakeInWhatAConventionDraws) {
    int tried = 0;
    for (std::uint64_t seed = 1; seed <= random_cases(10U); ++seed)
        for (const ConventionRow& row : convention_rows()) {
            const std::string text = scene_text_of(seed);
            const auto drawn = drawn_by(*rule_named(row.name), {"scene.json", text});
            if (!drawn || !drawn_by({}, {"scene.json", text}))
                continue;
            ++tried;
            const Diagnosis found = diagnosis_of(text, *drawn);
            EXPECT_FALSE(names_mistake(found))
                << row.name << ": " << name_of(found.answer.front().rule) << "\n"
                << text;
        }
    EXPECT_GT(tried, 0);
}

TEST(Diagnose, KnowsNothingOfRandomPictures) {
    std::mt19937 random(5);
    for (std::uint64_t seed = 1; seed <= random_cases(20U); ++seed) {
        const std::string text = scene_text_of(seed);
        auto drawn = drawn_by({}, {"scene.json", text});
        if (!drawn)
            continue;
        SeenCells seen = cells(*drawn);
        for (Color& color : seen.colors)
            color = random() % 2 == 0 ? Color(230, 25, 75) : no_color;
        const DrawnPair pair{{"scene.json", text}, seen};
        EXPECT_FALSE(names_mistake(diagnose({&pair, 1}, {}))) << text;
    }
}

TEST(Diagnose, SaysTheSameInSeveralThreads) {
    const std::string text = scene_text_of(3);
    const auto drawn = drawn_by(*rule_named("step-before-first"), {"scene.json", text});
    const Diagnosis one = diagnosis_of(text, *drawn);
    const Diagnosis four = diagnosis_of(text, *drawn, {.jobs = 4});
    ASSERT_EQ(one.answer.size(), four.answer.size());
    for (std::size_t i = 0; i < one.answer.size(); ++i)
        EXPECT_EQ(name_of(one.answer[i].rule), name_of(four.answer[i].rule));
    EXPECT_EQ(one.runner_up, four.runner_up);
}

TEST(TellApart, FindsASmallSceneThatTwoRulesDrawDifferently) {
    for (const Mistake& mistake : mistakes()) {
        if (mistake.put_in == nullptr || mistake.step == "matrix" || mistake.step == "light")
            continue;
        const auto scene = scene_apart({}, {{}, {&mistake}}, {{"fill", "top-left"}}, 40);
        if (!scene)
            continue;
        EXPECT_FALSE(are_alike(*drawn_by({}, *scene), *drawn_by({{}, {&mistake}}, *scene)))
            << mistake.name << "\n"
            << scene->text;
    }
}

} // namespace
} // namespace rastertrace
