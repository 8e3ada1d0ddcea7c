// SPDX-License-Identifier: MIT
// What a scene gets from "convention", and what it says itself.

#include "traces.h"

#include <rastertrace/core/draw/draw.h>
#include <rastertrace/trace/audit/redo.h>
#include <rastertrace/trace/record/traced_steps.h>
#include <rastertrace/trace/text/conventions.h>
#include <rastertrace/trace/text/method_names.h>

#include <fmt/core.h>
#include <gtest/gtest.h>

#include <map>
#include <set>
#include <string>
#include <utility>

namespace rastertrace {
namespace {

/// A square of two triangles with all vertices on whole numbers, in clip space: its shared edge leads through samples
/// of every kind.
std::string square(const std::string& convention, const std::string& more = {}) {
    return fmt::format(
        R"({{"canvas":{{"width":16,"height":16,"origin":"top-left"}},"convention":"{}",)"
        R"("vertices":{{"A":[-0.5,-0.5,0.5,1],"B":[0.5,-0.5,0.5,1],"C":[0.5,0.5,0.5,1],)"
        R"("D":[-0.5,0.5,0.5,1]}},"triangles":["ABC","ACD"]{}}})",
        convention, more);
}

std::size_t pixels_drawn_twice(const Trace& trace) {
    std::map<std::pair<Index, Index>, int> times;
    for (std::size_t n = 1; n <= trace.size(); ++n)
        if (trace.kind_of(n) == StepKind::pixel) {
            const auto step = trace.step(n).as<PixelStep>();
            ++times[{step.x, step.y}];
        }
    std::size_t twice = 0;
    for (const auto& [pixel, count] : times)
        twice += count > 1 ? 1 : 0;
    return twice;
}

TEST(Conventions, SetOnlyWhatMethodsKnow) {
    std::set<std::string_view> names;
    for (const ConventionRow& row : convention_rows()) {
        EXPECT_TRUE(names.insert(row.name).second) << row.name;
        EXPECT_EQ(row_of(row.convention), &row);
        for (const auto& [key, value] : row.method) {
            const MethodKey* const known = find_method_key(key);
            ASSERT_NE(known, nullptr) << row.name << ' ' << key;
            Method method;
            EXPECT_TRUE(known->set(method, value)) << row.name << ' ' << key << ' ' << value;
        }
    }
    EXPECT_EQ(row_of(Convention::none), nullptr);
}

/// Each pixel of the square is drawn once where the rule gives an edge to one triangle; else the nine samples on the
/// diagonal of 8 x 8 pixels are drawn by both.
TEST(Conventions, DrawASharedEdgeAsOftenAsTheirRuleSays) {
    const std::map<std::string, std::size_t> twice{
        {"opengl", 0},       {"direct3d", 0}, {"vulkan", 0},  {"cgfs", 9},
        {"tinyrenderer", 9}, {"cs418", 0},    {"scotty3d", 0}};
    for (const ConventionRow& row : convention_rows()) {
        const Trace trace = trace_of(scene_in(
            square(std::string(row.name), R"(,"method":{"scalar":"exact","depth":"none"})")));
        EXPECT_EQ(pixels_drawn_twice(trace), twice.at(std::string(row.name))) << row.name;
        EXPECT_EQ(trace.method.word_of("convention"), row.name);
        const Redone redone = redo(trace);
        EXPECT_EQ(redone.wrong, 0U) << row.name << redone.first.what;
    }
}

TEST(Conventions, WhatTheSceneSaysItselfWins) {
    const Scene scene = scene_in(square("cs418", R"(,"method":{"rows":"closed","depth":"ndc-z"})"));
    EXPECT_EQ(scene.method.rows, RowRule::closed);
    EXPECT_EQ(scene.method.rounding, Rounding::half_open);
    EXPECT_EQ(scene.depth(), Depth::ndc_z);
    EXPECT_TRUE(scene.viewport.is_y_down);

    // What the convention sets for another fill goes with it.
    const Scene other = scene_in(square("cs418", R"(,"method":{"fill":"top-left"})"));
    EXPECT_EQ(rows_of_triangles(other.method), RowRule::closed);
    EXPECT_EQ(other.method.fill, Fill::top_left);

    const Scene fitted = scene_in(square("opengl", R"(,"viewport":"fit")"));
    EXPECT_EQ(fitted.viewport.pixels, PixelRange::centers);
    EXPECT_FALSE(fitted.viewport.depths);

    const auto overridden =
        read_scene({"scene.json", square("opengl")}, {{"convention", "cs418"}, {"line", "dda"}});
    ASSERT_TRUE(overridden);
    EXPECT_EQ(overridden.value().scene.method.fill, Fill::scanline);
    EXPECT_EQ(overridden.value().scene.method.line, LineMethod::dda);
}

/// On the grid of 1/256, 0.501 is 1/2: the sample (1/2, 1/2) lies on AB, a right edge, which has no samples.
TEST(Conventions, OfHardwareSnapVerticesUnlessAskedForOtherNumbers) {
    const auto pixels = [](const std::string& more, const MethodOverrides& method = {}) {
        const auto scene =
            read_scene({"scene.json", R"({"canvas":{"width":2,"height":1,"origin":"top-left"},)"
                                      R"("vertices":{"A":[0.501,0],"B":[0.501,1],"C":[-3,0.5]},)"
                                      R"("triangles":["ABC"])" +
                                          more + "}"},
                       method);
        const Trace trace = trace_of(scene.value().scene);
        const bool has_pixel = trace.end->count.contains("pixel");
        return std::pair(std::string(trace.method.word_of("scalar")), has_pixel);
    };
    using Found = std::pair<std::string, bool>;
    for (const ConventionRow& row : convention_rows()) {
        const std::string name(row.name);
        const std::string says = R"(,"convention":")" + name + "\"";
        const bool is_hardware = name == "opengl" || name == "direct3d" || name == "vulkan";
        EXPECT_EQ(pixels(says).first, is_hardware ? "fixed" : "double") << name;
        if (!is_hardware)
            continue;
        EXPECT_EQ(pixels(says), Found("fixed", false)) << name;
        EXPECT_EQ(pixels("", {{"convention", name}}), Found("fixed", false)) << name;
        EXPECT_EQ(pixels(says + R"(,"method":{"scalar":"double"})"), Found("double", true)) << name;
        EXPECT_EQ(pixels(says, {{"scalar", "exact"}}), Found("exact", true)) << name;
    }
}

/// Direct3D and Vulkan have z in view from 0 to w, OpenGL from -w to w.
TEST(Conventions, SayWhichZIsInView) {
    const auto depths = [](const std::string& convention, const std::string& z) {
        const Trace trace = trace_of(scene_in(fmt::format(
            R"({{"canvas":{{"width":8,"height":8}},"convention":"{}","vertices":{{"A":[0,0,{},4]}},)"
            R"("points":["A"],"keep":["depth"],"method":{{"scalar":"exact"}}}})",
            convention, z)));
        std::vector<std::string> found;
        for (std::size_t n = 1; n <= trace.size(); ++n)
            if (trace.kind_of(n) == StepKind::depth)
                found.push_back(trace.step(n).as<DepthStep>().depth.exact()->get_str());
        return found;
    };
    using Texts = std::vector<std::string>;
    EXPECT_EQ(depths("opengl", "-2"), Texts{"1/4"});
    EXPECT_EQ(depths("opengl", "2"), Texts{"3/4"});
    EXPECT_EQ(depths("direct3d", "2"), Texts{"1/2"});
    EXPECT_EQ(depths("direct3d", "0"), Texts{"0"});
    EXPECT_EQ(depths("direct3d", "-2"), Texts{});
    EXPECT_EQ(depths("vulkan", "-1"), Texts{});
    EXPECT_EQ(depths("tinyrenderer", "-2"), Texts{"-1/2"});
}

TEST(Conventions, LeaveScenesInPixelsWhereTheyAre) {
    for (const ConventionRow& row : convention_rows()) {
        const Scene scene = scene_in(fmt::format(
            R"({{"canvas":{{"width":17,"height":14}},"convention":"{}","vertices":)"
            R"({{"A":[2,5],"B":[-4,-3],"C":[5,-3]}},"triangles":["ABC"],"lines":["AB"],)"
            R"("circles":[{{"center":"A","radius":2}}]}})",
            row.name));
        EXPECT_EQ(scene.viewport.type, ViewportType::none) << row.name;
        EXPECT_EQ(scene.depth(), Depth::none) << row.name;
    }
    EXPECT_EQ(refusal_of_scene(R"({"convention":"opngl","vertices":{"A":[0,0]},"points":["A"]})")
                  .starts_with("expected one of opengl, direct3d"),
              true);
}

} // namespace
} // namespace rastertrace
