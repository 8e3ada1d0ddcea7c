// SPDX-License-Identifier: MIT
#include <rastertrace/trace/record/step_stream.h>

#include "effort.h"
#include "picture.h"
#include "random_scene.h"
#include "traces.h"

#include <rastertrace/trace/explain/explain.h>
#include <rastertrace/trace/explain/steps_of_pixel.h>
#include <rastertrace/trace/tell/describe.h>
#include <rastertrace/trace/tell/working.h>

#include <rastertrace/trace/text/input_check.h>

#include <fmt/core.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <unistd.h>

#include <algorithm>
#include <cstddef>
#include <filesystem>
#include <fstream>
#include <string>
#include <utility>
#include <variant>
#include <vector>

namespace rastertrace {
namespace {

using ::testing::IsEmpty;

/// A file of this text, in a folder of its own.
class StepStreamTest : public testing::Test {
protected:
    StepStreamTest() {
        std::string pattern =
            (std::filesystem::temp_directory_path() / "rastertrace-XXXXXX").string();
        folder_ = ::mkdtemp(pattern.data());
    }
    ~StepStreamTest() override { std::filesystem::remove_all(folder_); }

    std::variant<StepStream, Source> opened(const std::string& text) const {
        const std::string path = (folder_ / "trace.json").string();
        std::ofstream(path) << text;
        return open_steps(path, {});
    }

    /// What a stream tells: the steps, and what is wrong.
    struct Told {
        std::vector<std::string> steps = {};
        std::vector<std::string> damage = {};
        std::string refused = {};
    };
    Told told_by(const std::string& text) const {
        auto either = opened(text);
        auto& stream = std::get<StepStream>(either);
        Told told;
        try {
            while (stream.next()) {
                EXPECT_EQ(stream.number(), told.steps.size() + 1);
                EXPECT_EQ(stream.kind(), stream.step().kind());
                told.steps.emplace_back(stream.step().json());
            }
        } catch (const Problem& problem) {
            told.refused = without_folder(to_text(problem));
        }
        for (const Problem& problem : stream.damage())
            told.damage.push_back(without_folder(to_text(problem)));
        return told;
    }

    std::string without_folder(std::string message) const {
        const std::string folder = folder_.string() + "/";
        if (const auto at = message.find(folder); at != std::string::npos)
            message.erase(at, folder.size());
        return message;
    }

    std::filesystem::path folder_;
};

/// So many steps that they come in several blocks.
Scene large_scene() {
    return triangle_scene({"0", "0", "400", "3", "7", "300"},
                          {.width = 401, .height = 301, .origin = Origin::bottom_left});
}

TEST_F(StepStreamTest, HasTheStepsOfBothLayouts) {
    for (const TraceLayout layout : {TraceLayout::json, TraceLayout::jsonl}) {
        const std::string text = trace_text(large_scene(), {.layout = layout, .filter = {}});
        ASSERT_GT(text.size(), 1'500'000U);
        const Told told = told_by(text);
        EXPECT_EQ(told.steps, steps_of(sound_trace(text)));
        EXPECT_THAT(told.damage, IsEmpty());
        EXPECT_EQ(told.refused, "");
    }
}

TEST_F(StepStreamTest, WhatIsNotAStepALineIsReadWhole) {
    const std::string scene = R"({"vertices":{"A":[1,2]},"points":["A"]})";
    EXPECT_EQ(std::get<Source>(opened(scene)).text, scene);
    const std::string on_one_line =
        R"({"rastertrace":1,"canvas":{"width":1,"height":1},"steps":[]})";
    EXPECT_EQ(std::get<Source>(opened(on_one_line)).text, on_one_line);
}

/// A trace that is cut off after any byte, or that lacks a line, is told as read_trace tells it.
TEST_F(StepStreamTest, TellsTheDamageThatReadTraceTells) {
    for (const TraceLayout layout : {TraceLayout::json, TraceLayout::jsonl}) {
        const std::string whole = trace_text(first_triangle(), {.layout = layout, .filter = {}});
        const std::size_t header = whole.find('\n') + 1;
        for (std::size_t size = header; size + 1 < whole.size(); size += 7) {
            const std::string cut = whole.substr(0, size);
            const Trace trace = readable_trace(cut);
            const Told told = told_by(cut);
            EXPECT_EQ(told.steps, steps_of(trace)) << size;
            EXPECT_EQ(told.damage, damage_of(trace)) << size;
        }
        std::string less = whole;
        const std::size_t line = less.find(R"({"step":"pixel")");
        less.erase(line, less.find('\n', line) + 1 - line);
        EXPECT_EQ(told_by(less).damage.front(), damage_of(readable_trace(less)).front());
    }
}

TEST_F(StepStreamTest, ALineThatIsNoStepIsRefusedWithItsNumber) {
    std::string text = trace_text(large_scene());
    const std::size_t at = text.rfind(R"({"step":"pixel","x")");
    text.replace(at, 18, R"({"step":"pixel","q)");
    const auto whole = read_trace({"trace.json", text});
    ASSERT_FALSE(whole);
    EXPECT_EQ(told_by(text).refused, to_text(whole.problem()));
}

/// A file of several blocks.
TEST_F(StepStreamTest, WhatIsReadInBlocksIsToldInTurn) {
    const std::string whole =
        trace_text(large_scene(), {.layout = TraceLayout::jsonl, .filter = {}});
    ASSERT_GT(whole.size(), 1'900'000U);
    const std::size_t place = whole.find('\n', 1'400'000) + 1;
    const auto lines =
        std::count(whole.begin(), whole.begin() + static_cast<std::ptrdiff_t>(place), '\n');
    const std::string at = fmt::format("trace.json:{}:", lines + 1);
    const auto with = [&](const std::string& line) {
        return whole.substr(0, place) + line + whole.substr(place);
    };
    for (const auto& [text, refused] : std::vector<std::pair<std::string, std::string>>{
             {whole, ""},
             {whole.substr(0, place + 20), ""},
             {with("7\n"), at},
             {with(std::string(longest_line + 2'000'000, 'x') + "\n"), at},
             {with("{\"end\":{}}\n"), "trace.json:"}}) {
        const Told in_turn = told_by(text);
        EXPECT_TRUE(in_turn.refused.starts_with(refused)) << in_turn.refused;
        EXPECT_EQ(in_turn.refused.empty(), refused.empty());
        EXPECT_GT(in_turn.steps.size(), 10'000U);
    }
}

/// A pixel asked of a stream and of the whole trace, also where a mistake makes each d another one than follows.
TEST_F(StepStreamTest, APixelIsAnsweredAlike) {
    Random random(3);
    int mistaken = 0;
    for (int i = 0; i < random_cases(300); ++i) {
        std::string scene_text = RandomScene(static_cast<std::uint64_t>(i)).text();
        if (i % 3 == 0)
            scene_text.insert(scene_text.find(R"("scalar")"),
                              R"("line":"bresenham","mistake":"factor-2-dropped",)");
        auto scene = read_scene({"scene.json", scene_text});
        if (!scene)
            continue;
        mistaken += scene.value().scene.method.mistake ? 1 : 0;
        const std::string text = trace_text(scene.value().scene);
        const Trace trace = sound_trace(text);
        const Question question{
            .about = Topic::pixel,
            .pixel = {random.whole(trace.canvas.left(), trace.canvas.right()),
                      trace.canvas.y_of(random.whole(0, trace.canvas.height - 1))}};
        auto either = opened(text);
        auto& stream = std::get<StepStream>(either);
        StepsOfPixel chosen(stream.header(), question.pixel);
        while (stream.next())
            chosen.take(stream.step(), stream.kind(), stream.number());
        Trace excerpt = std::move(chosen).finish();
        excerpt.end = stream.end();
        const auto here = explain(excerpt, question);
        const auto there = explain(trace, question);
        ASSERT_TRUE(here && there);
        EXPECT_EQ(here.value().answer, there.value().answer);
        EXPECT_EQ(here.value().lacks, there.value().lacks);
        ASSERT_EQ(here.value().tries.size(), there.value().tries.size());
        ASSERT_EQ(here.value().why_not.size(), there.value().why_not.size());
        Replay replay(trace, {.depths = true});
        for (std::size_t k = 0; k < here.value().tries.size(); ++k) {
            const Try& one = here.value().tries[k];
            replay.go_to(one.number);
            EXPECT_EQ(one.sentence, describe_step(replay)) << text;
            EXPECT_EQ(one.working, working_of(replay)) << text;
        }
        for (std::size_t k = 0; k < here.value().why_not.size(); ++k)
            EXPECT_EQ(here.value().why_not[k].sentence, there.value().why_not[k].sentence);
    }
    EXPECT_GT(mistaken, 0);
}

} // namespace
} // namespace rastertrace
