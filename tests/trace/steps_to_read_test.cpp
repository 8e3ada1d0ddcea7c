// SPDX-License-Identifier: MIT
// Of the nearest primitives of a pixel, and of how many others there are, the same is told as where each primitive is told
// of.

#include "effort.h"
#include "traces.h"

#include <rastertrace/trace/explain/explain.h>
#include <rastertrace/trace/explain/steps_to_read.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <fstream>
#include <iterator>
#include <map>
#include <string>
#include <vector>

namespace rastertrace {
namespace {

/// A triangle in each cell of a grid.
std::string many_triangles(std::string_view method) {
    std::string vertices;
    std::string triangles;
    constexpr int side = 7;
    for (int y = 0; y < side; ++y)
        for (int x = 0; x < side; ++x) {
            const std::string n = std::to_string(y * side + x);
            const auto add = [&](const char* name, int dx, int dy) {
                vertices += (vertices.empty() ? "\"" : ",\"") + std::string(name) + n + "\":[" +
                            std::to_string(7 * x + dx) + "," + std::to_string(7 * y + dy) + "]";
            };
            add("a", 0, x % 3);
            add("b", 9, 1);
            add("c", 1 + y % 4, 8);
            triangles +=
                (triangles.empty() ? "[\"a" : ",[\"a") + n + "\",\"b" + n + "\",\"c" + n + "\"]";
        }
    return R"({"canvas":{"width":56,"height":56,"origin":"bottom-left"},"vertices":{)" + vertices +
           R"(},"triangles":[)" + triangles + "],\"method\":{" + std::string(method) + "}}";
}

/// What people are told: the nearest, and how many others there are.
struct Told {
    std::string answer;
    std::vector<std::string> lines{};
    std::map<std::string, std::size_t> others{};

    bool operator==(const Told&) const = default;
};

Told told_of(Explanation explanation, std::size_t most) {
    Told told{.answer = explanation.question + ": " + explanation.answer,
              .lines = explanation.lacks,
              .others = explanation.farther};
    const auto add = [&told](const std::vector<std::string>& lines) {
        told.lines.insert(told.lines.end(), lines.begin(), lines.end());
    };
    for (const Try& one : explanation.tries) {
        add({std::to_string(one.number), one.step, one.primitive, one.sentence, one.before,
             one.after});
        add(one.working);
    }
    auto& why_not = explanation.why_not;
    std::stable_sort(why_not.begin(), why_not.end(), was_nearer_to_drawing);
    for (std::size_t i = 0; i < why_not.size(); ++i) {
        if (i >= most) {
            ++told.others[why_not[i].reason];
            continue;
        }
        add({why_not[i].primitive, why_not[i].reason, why_not[i].sentence});
        add(why_not[i].working);
    }
    return told;
}

/// Asks of the pixels of every so many rows and columns. Returns of how many pixels primitives were only counted.
std::size_t expect_same_answers(const Trace& trace, std::size_t most, int every) {
    std::size_t counted = 0;
    const Canvas& canvas = trace.canvas;
    for (int row = 0; row < canvas.height; row += every)
        for (int x = canvas.left(); x <= canvas.right(); x += every) {
            const Pixel pixel{x, canvas.y_of(row)};
            const Told expected = told_of(explain(trace, {.pixel = pixel}).value(), most);
            const Explanation answer =
                explain(trace, {.pixel = pixel, .most_why_not = most}).value();
            counted += answer.farther.empty() ? 0 : 1;
            const Told told = told_of(answer, most);
            EXPECT_EQ(told.answer, expected.answer);
            EXPECT_EQ(told.lines, expected.lines) << expected.answer;
            EXPECT_EQ(told.others, expected.others) << expected.answer;
            if (testing::Test::HasFailure())
                return counted;
        }
    return counted;
}

TEST(StepsToRead, TellOfTheExamplesAsAllStepsDo) {
    std::size_t counted = 0;
    for (const std::string& example : example_files()) {
        std::ifstream file(example, std::ios::binary);
        const auto scene =
            read_scene({example, std::string(std::istreambuf_iterator<char>(file), {})});
        constexpr std::size_t largest = 100'000;
        if (!scene)
            continue;
        const std::string text = trace_text(scene.value(), in_lines);
        if (text.size() > largest)
            continue;
        constexpr int every = all_cases(10) == 10 ? 8 : 24;
        counted += expect_same_answers(readable_trace(text), 2, every);
        ASSERT_FALSE(testing::Test::HasFailure()) << example;
    }
    EXPECT_GT(counted, all_cases(100U));
}

TEST(StepsToRead, AreFewOfManyTriangles) {
    for (const std::string method :
         {R"("fill":"top-left")", R"("fill":"scanline")", R"("fill":"barycentric")",
          R"("fill":"two-halves","rounding":"nearest")", R"("fill":"scanline","scalar":"float")",
          R"("fill":"top-left","scalar":"fixed")"}) {
        const Trace trace = readable_trace(trace_text(scene_in(many_triangles(method)), in_lines));
        EXPECT_EQ(expect_same_answers(trace, most_why_not_told, 4), 14U * 14U) << method;
        ASSERT_FALSE(testing::Test::HasFailure()) << method;
        const auto chosen = steps_to_read(trace, {3, 3}, 1);
        ASSERT_TRUE(chosen);
        EXPECT_LT(chosen->steps.size(), trace.size() / 2) << method;
    }
}

} // namespace
} // namespace rastertrace
