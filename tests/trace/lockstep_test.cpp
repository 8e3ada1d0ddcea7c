// SPDX-License-Identifier: MIT
// A sink that is held against a reference: it says nothing of the same drawing, and stops at the step that diff tells.

#include "effort.h"
#include "picture.h"
#include "random_scene.h"
#include "traces.h"

#include <rastertrace/core/draw/draw.h>
#include <rastertrace/trace/compare/lockstep.h>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <optional>
#include <string>

namespace rastertrace {
namespace {

/// What a drawing by a method does otherwise than one by the scene's own, by a sink and by diff.
struct BothWays {
    std::optional<StepDifference> by_sink;
    TraceDiff by_diff;
};

std::optional<BothWays> compared(const std::string& scene, const MethodOverrides& method) {
    const auto one = read_scene({"scene.json", scene, {}});
    const auto other = read_scene({"scene.json", scene, {}}, method);
    if (!one || !other)
        return std::nullopt;
    const TraceText reference({"one", trace_text(one.value(), in_lines), {}});
    const TraceText now({"other", trace_text(other.value(), in_lines), {}});
    BothWays found{.by_sink = {}, .by_diff = diff(reference, now, {})};
    Lockstep sink = compare_with(reference, {}, [&found](const StepDifference& difference) {
        EXPECT_FALSE(found.by_sink) << "it is called once";
        found.by_sink = difference;
    });
    draw(other.value().scene, other.value().plan, sink);
    sink.end();
    EXPECT_EQ(sink.has_differed(), found.by_sink.has_value());
    return found;
}

TEST(Lockstep, SaysNothingOfTheSameDrawing) {
    for (std::uint64_t seed = 0; seed < random_cases<std::uint64_t>(200); ++seed)
        if (const auto found = compared(RandomScene(seed).text(), {})) {
            EXPECT_FALSE(found->by_sink) << RandomScene(seed).text();
            EXPECT_TRUE(found->by_diff.is_same);
        }
}

TEST(Lockstep, StopsAtTheFirstStepThatDiffers) {
    int changed = 0;
    for (std::uint64_t seed = 0; seed < random_cases<std::uint64_t>(200); ++seed) {
        const auto found = compared(RandomScene(seed).text(), {{"rounding", "truncate"}});
        if (!found)
            continue;
        const bool has_steps = !found->by_diff.kinds.empty();
        ASSERT_EQ(found->by_sink.has_value(), has_steps) << diff_text(found->by_diff);
        if (!has_steps || found->by_diff.first->fields.empty())
            continue;
        ++changed;
        EXPECT_EQ(found->by_sink->kind, found->by_diff.first->kind);
        EXPECT_EQ(found->by_sink->primitive, found->by_diff.first->primitive);
        ASSERT_TRUE(found->by_sink->a && found->by_sink->b);
        EXPECT_EQ(found->by_sink->a->sentence, found->by_diff.first->a->sentence);
        EXPECT_EQ(found->by_sink->b->number, found->by_diff.first->b->number);
    }
    EXPECT_GT(changed, random_cases(10));
}

TEST(Lockstep, WhatIsMissingInTheEndIsADifference) {
    const TraceText reference({"trace", trace_text(first_triangle(), in_lines), {}});
    std::optional<StepDifference> found;
    Lockstep sink = compare_with(reference, {.only = {"pixel"}},
                                 [&found](const StepDifference& one) { found = one; });
    sink(PixelPlotted{.pixel = {2, 5}, .color = {}});
    EXPECT_FALSE(sink.has_differed());
    sink.end();
    ASSERT_TRUE(found);
    EXPECT_FALSE(found->b);
    EXPECT_EQ(found->kind, "pixel");
}

} // namespace
} // namespace rastertrace
