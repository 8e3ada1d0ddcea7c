// SPDX-License-Identifier: MIT
// Steps in memory are what their text is, and are found by their kind as a walk through all of them finds them.

#include "effort.h"
#include "random_choice.h"
#include "random_scene.h"
#include "traces.h"

#include <rastertrace/trace/record/trace.h>
#include <rastertrace/trace/record/traced_steps.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <string>
#include <utility>
#include <vector>

namespace rastertrace {
namespace {

StepKindSet random_kinds(Random& random) {
    StepKindSet kinds;
    for (std::size_t kind = 0; kind < step_kinds; ++kind)
        if (random.chance(6))
            kinds.add(static_cast<StepKind>(kind));
    return kinds;
}

/// The steps of some kinds; other steps are asked for between them.
std::vector<std::size_t> found(const Trace& trace, StepKindSet kinds, std::size_t first,
                               std::size_t last) {
    std::vector<std::size_t> steps;
    for (const std::size_t n : trace.steps_of(kinds, first, last)) {
        steps.push_back(n);
        (void)trace.kind_of(trace.size() + 1 - n);
        (void)trace.step(1 + n / 2);
    }
    return steps;
}

std::vector<std::size_t> walked_to(const Trace& trace, StepKindSet kinds, std::size_t first,
                                   std::size_t last) {
    std::vector<std::size_t> steps;
    for (std::size_t n = first; n <= std::min(last, trace.size()); ++n)
        if (const auto kind = trace.kind_of(n); kind && kinds.has(*kind))
            steps.push_back(n);
    return steps;
}

/// A step that is asked for behind any other one, or before it, is the same.
void expect_same_in_any_order(const Trace& trace, Random& random) {
    std::vector<std::string> in_turn;
    for (std::size_t n = 1; n <= trace.size(); ++n)
        in_turn.push_back(trace.step(n).json());
    for (int i = 0; i < 200 && trace.size() > 0; ++i) {
        auto n = static_cast<std::size_t>(random.whole(1, static_cast<int>(trace.size())));
        for (int near = random.whole(1, 3); near > 0 && n > 0; --near, --n) {
            ASSERT_EQ(trace.step(n).json(), in_turn[n - 1]) << n;
            const auto last =
                std::min(n + static_cast<std::size_t>(random.whole(0, 3)), trace.size());
            std::size_t known = n;
            while (known <= last && !trace.kind_of(known))
                ++known;
            ASSERT_EQ(trace.next_of(StepKindSet::all(), n, last), known) << n << " to " << last;
        }
    }
}

/// A trace with a blank in front of some of its steps, which are then no plain ones, and with a kind that nobody knows.
std::string foreign(std::string text, Random& random) {
    const std::string step = "\n{\"step\"";
    for (std::size_t at = text.find(step); at != std::string::npos; at = text.find(step, at + 1))
        if (random.chance(20))
            text.insert(at + 1, random.chance(2) ? " " : "{\"step\":\"other\"}\n");
    return text;
}

TEST(Steps, TheNextStepOfAKindIsTheOneThatAWalkComesTo) {
    std::size_t steps = 0;
    for (std::uint64_t seed = 1; seed <= 100; ++seed) {
        const auto scene = read_scene({"scene.json", RandomScene(seed).text()});
        if (!scene)
            continue;
        Random random(seed);
        const std::string text = trace_text(scene.value(), in_lines);
        const auto& [drawn, plan, notes] = scene.value();
        for (const Trace& trace : {readable_trace(text), readable_trace(foreign(text, random)),
                                   drawn_trace(drawn, plan, "scene.json", 1'000'000)}) {
            const StepKindSet kinds = random_kinds(random);
            const std::size_t behind = trace.size() + 1;
            for (const std::size_t first : {std::size_t{1}, (behind + 1) / 2, behind, behind + 9})
                for (const std::size_t last : {std::size_t{0}, behind / 2, behind - 1, behind + 9})
                    EXPECT_EQ(found(trace, kinds, first, last),
                              walked_to(trace, kinds, first, last))
                        << "seed " << seed << ", " << first << " to " << last;
            EXPECT_EQ(found(trace, {}, 1, behind), std::vector<std::size_t>());
            expect_same_in_any_order(trace, random);
            steps += walked_to(trace, kinds, 1, behind).size();
        }
    }
    EXPECT_GT(steps, 10'000U);
}

/// A trace of a scene that is drawn has the steps that its text has, and they read and write alike.
TEST(Steps, OfADrawingAreThoseOfItsText) {
    std::size_t compared = 0;
    for (std::uint64_t seed = 1; seed <= random_cases(std::uint64_t{400}); ++seed) {
        const auto scene = read_scene({"scene.json", RandomScene(seed).text()});
        if (!scene)
            continue;
        const auto& [drawn, plan, notes] = scene.value();
        const Trace held = drawn_trace(drawn, plan, "scene.json", any_number);
        const std::string text = trace_text(scene.value(), in_lines);
        const Trace read = readable_trace(text);
        ASSERT_EQ(held.size(), read.size()) << "seed " << seed;
        std::string lines = text.substr(0, text.find('\n') + 1);
        for (std::size_t n = 1; n <= read.size(); ++n) {
            ASSERT_EQ(held.step(n).json(), read.step(n).json()) << "seed " << seed;
            ASSERT_EQ(held.step(n).fields(), read.step(n).fields());
            lines += held.step(n).json() + "\n";
        }
        EXPECT_EQ(text.substr(0, lines.size()), lines) << "seed " << seed;
        EXPECT_EQ(held.end->frame, read.end->frame);
        compared += read.size();
    }
    EXPECT_GT(compared, all_cases(10'000U));
}

/// Numbers, colors, names and fields that this program would write otherwise read back as they were typed.
TEST(Steps, WhatWasTypedStays) {
    const std::vector<std::string> typed{
        R"({"step":"scanline","y":2,"left":1.50,"right":"4/2","from":1,"to":2})",
        R"({"step":"scanline","y":-0,"left":1E0,"right":"NaN","from":1,"to":2})",
        R"({"step":"pixel","y":1,"x":2})",
        R"({"step":"pixel","x":2,"y":1,"color":"#FF8000"})",
        R"({"step":"pixel","x":2,"y":1,"code":"raster.cpp:120"})",
        R"({ "step": "primitive", "kind": "triangle", "name": "A\u0042C" })",
        R"({"step":"wobble","how":[1,{"far":2.50}]})",
    };
    std::string text = "{\"rastertrace\":1,\"canvas\":{\"width\":3,\"height\":3}}\n";
    for (const std::string& line : typed)
        text += line + "\n";
    const Trace trace = readable_trace(text + "{\"end\":{}}\n");
    ASSERT_EQ(trace.size(), typed.size());
    for (std::size_t n = 1; n <= typed.size(); ++n)
        EXPECT_EQ(trace.step(n).json(), typed[n - 1]);
    EXPECT_EQ(trace.step(1).as<ScanlineStep>().left.text(), "1.50");
    EXPECT_EQ(trace.step(6).as<PrimitiveStep>().name.text(), "ABC");
}

} // namespace
} // namespace rastertrace
