// SPDX-License-Identifier: MIT
// The model draws what the book draws in exact numbers, and decides alike.

#include <rastertrace/core/draw/draw.h>
#include <rastertrace/core/draw/model/model.h>
#include <rastertrace/trace/record/step_tracer.h>
#include <rastertrace/trace/record/step_writer.h>
#include <rastertrace/trace/text/input.h>

#include "effort.h"
#include "random_scene.h"
#include "traces.h"

#include <fmt/core.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cstdint>
#include <map>
#include <sstream>
#include <string>
#include <vector>

namespace rastertrace {
namespace {

/// False of a row that has no pixel on the canvas: of a triangle that lies beside it, the book tells none.
bool has_pixels(const std::string& step, const Canvas& canvas) {
    const std::size_t from = step.find("\"from\":");
    if (from == std::string::npos)
        return true;
    const std::size_t to = step.find("\"to\":", from);
    return std::stoll(step.substr(from + 7)) <= canvas.right() &&
           std::stoll(step.substr(to + 5)) >= canvas.left();
}

/// What is told of a drawing, a line for each step, in sorted order. Rows of top-left are told by the book alone, which
/// finds them without asking each sample. What lies off the canvas, and why nothing is drawn, the book tells in fewer
/// words.
template <typename Draw> std::string told(const Scene& scene, Draw&& draw, Image& image) {
    std::string text;
    StringOutput output(text);
    StepFilter filter;
    filter.only = {StepKind::matrix, StepKind::vertex, StepKind::order,  StepKind::primitive,
                   StepKind::face,   StepKind::light,  StepKind::clip,   StepKind::ray,
                   StepKind::sample, StepKind::along,  StepKind::decide, StepKind::depth,
                   StepKind::pixel};
    if (scene.method.fill != Fill::top_left)
        filter.only->insert(filter.only->end(), {StepKind::scanline, StepKind::edge});
    StepWriter writer(output, TraceLayout::jsonl);
    Arena arena;
    StepTracer<StepWriter> tracer(writer, arena, false, filter);
    image = draw(tracer);
    writer.flush();
    std::vector<std::string> lines;
    std::istringstream in(text);
    for (std::string line; std::getline(in, line);)
        if (!line.empty() && has_pixels(line, scene.canvas))
            lines.push_back(line);
    std::sort(lines.begin(), lines.end());
    std::string sorted;
    for (const std::string& line : lines)
        sorted += line + "\n";
    return sorted;
}

/// True if the model draws such a scene; then it is to decide as the book does.
bool is_drawn_alike(const std::string& name, const Source& source, MethodOverrides settings = {}) {
    settings.emplace_back("scalar", "exact");
    auto read = read_scene(source, settings);
    if (!read || !has_model(read.value().scene))
        return false;
    Scene& scene = read.value().scene;
    scene.keep.add(Stage::depth); // the model leaves nothing out
    SCOPED_TRACE(name + "\n" + (source.text.size() < 3000 ? source.text : ""));
    Image by_book(scene.canvas);
    Image by_model(scene.canvas);
    const std::string of_book = told(
        scene, [&](auto& writer) { return draw(scene, plan_for(scene), writer); }, by_book);
    const ModelRules rules(scene);
    const std::string of_model = told(
        scene, [&](auto& writer) { return draw_by(rules, writer); }, by_model);
    EXPECT_TRUE(std::equal(by_book.colors().begin(), by_book.colors().end(),
                           by_model.colors().begin(), by_model.colors().end()));
    EXPECT_EQ(of_model, of_book);
    return true;
}

TEST(ModelRasterizer, WalksNoLineOfAThousandMillionPixels) {
    const auto scene = [](const std::string& more) {
        return scene_in(R"({"canvas": {"width": 9, "height": 9}, "lines": ["AB"],
            "vertices": {"A": [0, 0, 0], "B": [3, 4, 1e9]})" +
                        more + "}");
    };
    EXPECT_TRUE(has_model(scene("")));
    EXPECT_FALSE(has_model(scene(R"(, "model": [{"rotate": {"axis": "x", "degrees": 90}}])")));
    EXPECT_FALSE(has_model(scene(R"(, "model": [{"scale": [1e5, 1, 1]}])")));
    EXPECT_TRUE(has_model(scene(R"(, "model": [{"scale": [100, 1, 1]}])")));
    EXPECT_FALSE(has_model(scene(R"(, "camera": {"position": [1, 0, 0]},
                                      "projection": {"type": "none"})")));
}

TEST(ModelRasterizer, DrawsTheExamplesAsTheBookDoes) {
    int drawn = 0;
    for (const std::string& file : example_files()) {
        auto source = read_source(file, {});
        if (source && is_drawn_alike(file, source.value()))
            ++drawn;
        if (HasFailure())
            break;
    }
    EXPECT_GT(drawn, 40);
}

TEST(ModelRasterizer, DrawsRandomScenesAsTheBookDoes) {
    int drawn = 0;
    const int scenes = random_cases(3000);
    for (int seed = 1; seed <= scenes && !HasFailure(); ++seed)
        drawn +=
            is_drawn_alike(std::to_string(seed),
                           {"scene.json", RandomScene(static_cast<std::uint64_t>(seed)).text()});
    EXPECT_GT(drawn, scenes / 2);
}

TEST(ModelRasterizer, DrawsEveryFillAndLineAsTheBookDoes) {
    std::map<std::string, int> drawn;
    const int scenes = random_cases(2500);
    for (int seed = 1; seed <= scenes && !HasFailure(); ++seed) {
        Random random(static_cast<std::uint64_t>(seed));
        const Source source{"scene.json", RandomScene(static_cast<std::uint64_t>(seed)).text()};
        const Fill fill = all_fills[static_cast<std::size_t>(
            random.whole(0, static_cast<int>(all_fills.size()) - 1))];
        const LineMethod line = all_lines[static_cast<std::size_t>(
            random.whole(0, static_cast<int>(all_lines.size()) - 1))];
        const std::string of_fill(traits_of(fill).name), of_line(traits_of(line).name);
        if (is_drawn_alike(std::to_string(seed), source,
                           {{"fill", of_fill},
                            {"line", of_line},
                            {"rows", random.pick<const char*>({"closed", "half-open"})}})) {
            ++drawn[of_fill];
            ++drawn[of_line];
        }
    }
    for (const Fill fill : all_fills)
        EXPECT_GT(drawn[std::string(traits_of(fill).name)], scenes / 50) << traits_of(fill).name;
    for (const LineMethod line : all_lines)
        EXPECT_GT(drawn[std::string(traits_of(line).name)], scenes / 50) << traits_of(line).name;
}

TEST(ModelRasterizer, DrawsCirclesAsTheBookDoes) {
    for (int seed = 1; seed <= random_cases(500) && !HasFailure(); ++seed) {
        Random random(static_cast<std::uint64_t>(seed));
        const auto near = [&random] {
            return std::to_string(random.whole(-30, 30)) + random.pick<const char*>({"", ".5"});
        };
        const std::string text = fmt::format(
            R"({{"canvas": {{"width": 40, "height": 30, "origin": "{}"}},
                 "vertices": {{"A": [{}, {}]}}, "circles": [{{"center": "A", "radius": {}}}],
                 "method": {{"sample": "{}"}}}})",
            random.pick<const char*>({"center", "top-left", "bottom-left"}), near(), near(),
            random.whole(0, 40), random.pick<const char*>({"integer", "center"}));
        EXPECT_TRUE(is_drawn_alike(text, {"circle.json", text}));
    }
}

} // namespace
} // namespace rastertrace
