// SPDX-License-Identifier: MIT
// Which rule accounts for what was drawn: each known mistake is found again in what it draws, and none in what is right.

#include <rastertrace/core/draw/draw.h>
#include <rastertrace/trace/diagnose/diagnosis.h>
#include <rastertrace/trace/diagnose/tell_apart.h>
#include <rastertrace/trace/fuzz/fuzz_scene.h>
#include <rastertrace/trace/text/conventions.h>
#include <rastertrace/trace/text/input.h>

#include "effort.h"
#include "random_scene.h"
#include "traces.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <cstdlib>
#include <filesystem>
#include <iostream>
#include <optional>
#include <random>
#include <set>
#include <string>
#include <string_view>
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

/// How many scenes a mistake is looked for in; scripts/check-diagnose.sh takes more.
int scenes_of_each() {
    const char* const asked = std::getenv("RASTERTRACE_DIAGNOSE_SCENES");
    return asked == nullptr ? std::max(1, random_cases(20) / 10) : std::stoi(asked);
}

/// Of random scenes that each picture is asked about, from 1 on.
std::uint64_t last_seed() {
    return static_cast<std::uint64_t>(std::max(3, scenes_of_each() * random_cases(10)));
}

/// The mistakes that are looked for: all of them, or each tenth under the sanitizers.
std::vector<const Mistake*> looked_for() {
    constexpr std::size_t step = 10 / all_cases<std::size_t>(10);
    std::vector<const Mistake*> some;
    for (std::size_t i = 0; i < mistakes().size(); i += step)
        some.push_back(&mistakes()[i]);
    return some;
}

std::size_t changed_pixels(const Image& a, const Image& b) {
    std::size_t count = 0;
    for (std::size_t i = 0; i < a.colors().size(); ++i)
        count += a.colors()[i] != b.colors()[i];
    return count;
}

std::size_t drawn_pixels(const Image& image) {
    return image.colors().size() -
           static_cast<std::size_t>(std::ranges::count(image.colors(), no_color));
}

/// A scene whose picture a rule changes.
struct ChangedScene {
    std::string text;
    Image asked;
    Image drawn;
};

/// A scene as it is asked for and as a rule draws it, if these differ.
std::optional<ChangedScene> changed_by(const Rule& rule, const std::string& text) {
    const Source source{"scene.json", text};
    const auto read = read_scene(source, {{"scalar", "exact"}});
    const auto concerns = [&read](const Mistake* one) { return one->concerns(read.value().scene); };
    if (!read || !has_model(read.value().scene) || !std::ranges::all_of(rule.mistakes, concerns))
        return std::nullopt;
    auto drawn = drawn_by(rule, source);
    auto asked = drawn_by({}, source);
    if (!drawn || are_alike(*drawn, *asked))
        return std::nullopt;
    return ChangedScene{text, std::move(*asked), std::move(*drawn)};
}

/// Random scenes, from a seed on, that a rule draws otherwise than they ask; if there are none, examples.
std::vector<ChangedScene> scenes_changed_by(const Rule& rule, std::uint64_t first, int count) {
    constexpr std::uint64_t tries = 400;
    std::vector<ChangedScene> changed;
    const auto add = [&](const std::string& text) {
        if (auto scene = changed_by(rule, text))
            changed.push_back(std::move(*scene));
        return static_cast<int>(changed.size()) == count;
    };
    for (std::uint64_t seed = first; seed < first + tries; ++seed)
        if (add(scene_text_of(seed)))
            return changed;
    if (changed.empty())
        for (const char* const folder : {"mistakes", "t3-light", "tutorial/light"}) {
            std::set<std::filesystem::path> sorted; // folders list their files in any order
            for (const auto& entry : std::filesystem::directory_iterator(
                     std::string(RASTERTRACE_EXAMPLES "/") + folder))
                sorted.insert(entry.path());
            for (const auto& path : sorted)
                if (path.extension() == ".json" && add(read_source(path.string(), {}).value().text))
                    return changed;
        }
    return changed;
}

/// Other scenes for each mistake.
std::uint64_t seed_of(const Mistake& mistake) {
    return static_cast<std::uint64_t>(&mistake - mistakes().data()) * 97 + 1;
}

/// What scripts/check-diagnose.sh makes its table of.
void tell(std::string_view row, int hits, int all) {
    std::cout << "row: " << row << ": " << hits << " of " << all << "\n";
}

TEST(Diagnose, FindsEachMistakeInWhatItDraws) {
    int all = 0;
    int named = 0;
    int short_answers = 0;
    for (const Mistake* const mistake : looked_for()) {
        const auto scenes = scenes_changed_by({{}, {mistake}}, seed_of(*mistake), scenes_of_each());
        EXPECT_FALSE(scenes.empty()) << "no scene shows " << mistake->name;
        for (const ChangedScene& scene : scenes) {
            const Diagnosis found = diagnosis_of(scene.text, scene.drawn);
            ++all;
            EXPECT_EQ(found.unexplained, 0U) << mistake->name << "\n" << scene.text;
            named += has(found, *mistake);
            short_answers += found.answer.size() <= 3;
            if (!has(found, *mistake))
                std::cout << mistake->name << " is not among the answers, of which the first is "
                          << name_of(found.answer.front().rule) << "\n"
                          << scene.text << "\n";
        }
    }
    tell("the mistake is in the answer", named, all);
    tell("the answer has at most 3 members", short_answers, all);
    EXPECT_GE(named * 100, all * 99);
    EXPECT_GE(short_answers * 100, all * 85);
}

TEST(DiagnoseTwo, FindsTwoMistakesWhereNoSingleRuleDrawsThem) {
    const int count = std::max(all_cases(10), scenes_of_each() * 3 / 2);
    std::mt19937 random(43);
    int all = 0;
    int both_named = 0;
    while (all < count) {
        const Mistake& a = mistakes()[random() % mistakes().size()];
        const Mistake& b = mistakes()[random() % mistakes().size()];
        if (a.put_in == nullptr || b.put_in == nullptr || a.is_rule() || b.is_rule() || &a == &b)
            continue;
        const Rule both{{}, {&a, &b}};
        for (const ChangedScene& scene : scenes_changed_by(both, random() % 100'000, 1)) {
            const Diagnosis found = diagnosis_of(scene.text, scene.drawn);
            const bool is_by_one = !found.answer.empty() && found.unexplained == 0 &&
                                   found.answer.front().rule.mistakes.size() < 2;
            if (is_by_one)
                continue; // one rule draws all of it: nobody could know better
            ++all;
            bool names_one = false;
            bool names_both = false;
            for (const AnsweredRule& one : found.answer) {
                const auto names = [&](const Mistake& mistake) {
                    return std::ranges::find(one.rule.mistakes, &mistake) !=
                               one.rule.mistakes.end() ||
                           std::ranges::find(one.same, &mistake) != one.same.end();
                };
                names_one = names_one || names(a) || names(b);
                names_both = names_both || (names(a) && names(b));
            }
            both_named += names_both;
            if (!names_both)
                std::cout << a.name << ", " << b.name << ": "
                          << (found.answer.empty() ? "nothing" : name_of(found.answer.front().rule))
                          << ", " << found.unexplained << " of " << found.differing << " left\n";
            EXPECT_TRUE(found.answer.empty() || names_both || found.unexplained > 0 || names_one)
                << a.name << ", " << b.name << "\n"
                << scene.text;
        }
    }
    tell("both of two mistakes are named", both_named, all);
    EXPECT_GE(both_named * 100, are_all_cases ? all * 70 : 0); // of 10; 80 of 300
}

// Mistakes that no one has made together must not end the program, nor mistakes in what a scene does not have. Vertices
// that are not sorted have heights below 0.
TEST(DiagnoseTwo, AnyMistakesDrawTogether) {
    const Source scene{"scene.json", R"({"canvas": {"width": 9, "height": 9, "origin": "top-left"},
        "vertices": {"A": [1, 2, 3], "B": [7, 1, 2], "C": [3, 7, 4]}, "triangles": ["BAC"],
        "method": {"depth": "linear-z"}})"};
    std::size_t drawn = 0;
    for (const Mistake* const a : looked_for())
        for (const Mistake& b : mistakes())
            drawn += drawn_by({{}, {a, &b}}, scene) ? 1 : 0;
    EXPECT_GT(drawn, looked_for().size() * mistakes().size() / 2);
}

TEST(DiagnoseNoise, FindsAMistakeThoughAFewPixelsAreOff) {
    std::mt19937 random(7);
    int all = 0;
    int named = 0;
    for (const Mistake* const mistake : looked_for())
        for (const ChangedScene& scene :
             scenes_changed_by({{}, {mistake}}, seed_of(*mistake) + 50'000, scenes_of_each())) {
            const std::size_t drawn = drawn_pixels(scene.drawn);
            if (changed_pixels(scene.asked, scene.drawn) * 20 < drawn || drawn < 100)
                continue;
            ++all;
            SeenCells seen = cells(scene.drawn);
            for (std::size_t i = 0; i < drawn / 100; ++i) {
                Color& color = seen.colors[random() % seen.colors.size()];
                color = color == no_color ? Color(230, 25, 75) : no_color;
            }
            const DrawnPair pair{{"scene.json", scene.text}, seen};
            const Diagnosis found = diagnose({&pair, 1}, {});
            named += has(found, *mistake);
            if (!has(found, *mistake))
                std::cout << mistake->name << ": "
                          << (found.answer.empty() ? "nothing" : name_of(found.answer.front().rule))
                          << "\n";
        }
    tell("the mistake is found though 1 % of the pixels are flipped", named, all);
    EXPECT_GE(named * 100, all * 97);
}

TEST(Diagnose, PredictsOtherScenes) {
    int all = 0;
    int right = 0;
    const std::size_t every = scenes_of_each() < 10 ? 9 : 1;
    for (std::size_t i = 0; i < mistakes().size(); i += every) {
        const Mistake& mistake = mistakes()[i];
        const Rule rule{{}, {&mistake}};
        const auto others = scenes_changed_by(rule, seed_of(mistake) + 70'000, all_cases(10));
        for (const ChangedScene& scene :
             scenes_changed_by(rule, seed_of(mistake) + 90'000, scenes_of_each())) {
            const Diagnosis found = diagnosis_of(scene.text, scene.drawn);
            if (found.answer.size() != 1 || scene.asked.canvas().height < 10)
                continue;
            for (const ChangedScene& other : others) {
                ++all;
                const auto predicted =
                    drawn_by(found.answer.front().rule, {"scene.json", other.text});
                right += predicted && are_alike(*predicted, other.drawn);
            }
        }
    }
    tell("an answer with one member predicts other scenes", right, all);
    EXPECT_GE(right * 100, all * (every > 1 ? 90 : 95)); // of 8 answers, one that is wrong is much
}

TEST(DiagnoseNoise, NamesNoMistakeInWhatAConventionDraws) {
    int tried = 0;
    int wrong = 0;
    for (std::uint64_t seed = 1; seed <= last_seed(); ++seed)
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
            wrong += names_mistake(found);
        }
    tell("a mistake is named in what a convention draws", wrong, tried);
    EXPECT_GT(tried, 0);
}

TEST(DiagnoseNoise, KnowsNothingOfRandomPictures) {
    std::mt19937 random(5);
    int tried = 0;
    int wrong = 0;
    for (std::uint64_t seed = 1; seed <= last_seed(); ++seed) {
        const std::string text = scene_text_of(seed);
        auto drawn = drawn_by({}, {"scene.json", text});
        if (!drawn)
            continue;
        SeenCells seen = cells(*drawn);
        for (Color& color : seen.colors)
            color = random() % 2 == 0 ? Color(230, 25, 75) : no_color;
        const DrawnPair pair{{"scene.json", text}, seen};
        ++tried;
        const bool is_named = names_mistake(diagnose({&pair, 1}, {}));
        wrong += is_named;
        EXPECT_FALSE(is_named) << text;
    }
    tell("a mistake is named in a random picture", wrong, tried);
}

TEST(Diagnose, SaysTheSameInSeveralThreads) {
    const auto scenes = scenes_changed_by(*rule_named("step-before-first"), 1, 1);
    ASSERT_EQ(scenes.size(), 1U);
    const auto& [text, asked, drawn] = scenes.front();
    const Diagnosis one = diagnosis_of(text, drawn);
    const Diagnosis four = diagnosis_of(text, drawn, {.jobs = 4});
    EXPECT_GT(one.differing, 0U);
    ASSERT_EQ(one.answer.size(), four.answer.size());
    for (std::size_t i = 0; i < one.answer.size(); ++i)
        EXPECT_EQ(name_of(one.answer[i].rule), name_of(four.answer[i].rule));
    EXPECT_EQ(one.runner_up, four.runner_up);
}

TEST(TellApart, FindsASmallSceneThatTwoRulesDrawDifferently) {
    for (const Mistake* const mistake : looked_for()) {
        if (mistake->put_in == nullptr || mistake->step == "matrix" || mistake->step == "light")
            continue;
        const auto scene = scene_apart({}, {{}, {mistake}}, {{"fill", "top-left"}}, 40);
        if (!scene)
            continue;
        EXPECT_FALSE(are_alike(*drawn_by({}, *scene), *drawn_by({{}, {mistake}}, *scene)))
            << mistake->name << "\n"
            << scene->text;
    }
}

} // namespace
} // namespace rastertrace
