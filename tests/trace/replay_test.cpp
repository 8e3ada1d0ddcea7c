// SPDX-License-Identifier: MIT
// A replay that goes back by its keyframes is the one that plays every step.

#include "random_choice.h"
#include "random_scene.h"
#include "same_replay.h"
#include "traces.h"

#include <rastertrace/trace/record/replay.h>
#include <rastertrace/trace/tell/describe.h>

#include <gtest/gtest.h>

#include <cstdint>
#include <string>

namespace rastertrace {
namespace {

constexpr FrameParts every_part{.writes = true, .depths = true};

/// Everything that a replay tells.
void expect_same_told(const Replay& one, const Replay& other) {
    expect_same(one, other);
    EXPECT_EQ(describe_step(one), describe_step(other));
}

/// A scene with so many triangles over each other, on a canvas of several tiles.
std::string many_triangles(int count) {
    std::string text =
        R"({"canvas":{"width":128,"height":96,"origin":"top-left"},"method":{"depth":"linear-z"},"vertices":{)";
    std::string triangles;
    Random random(5);
    for (int i = 0; i < count; ++i) {
        for (const char* const corner : {"A", "B", "C"})
            text += "\"" + std::string(corner) + std::to_string(i) + "\":[" +
                    std::to_string(random.whole(0, 127)) + "," +
                    std::to_string(random.whole(0, 95)) + "," + std::to_string(random.whole(1, 9)) +
                    "]" + (i + 1 == count && *corner == 'C' ? "" : ",");
        const std::string n = std::to_string(i);
        triangles += (i == 0 ? "" : ",") + ("[\"A" + n + "\",\"B" + n + "\",\"C" + n + "\"]");
    }
    return text + "},\"triangles\":[" + triangles + "]}";
}

/// Random moves of two that share keyframes of so many bytes, each against a replay that plays every step.
void expect_any_step(const Trace& trace, std::size_t bytes, int moves) {
    Replay one(trace, every_part, bytes);
    Replay other(one);
    Random random(trace.size());
    for (int i = 0; i < moves; ++i) {
        const auto n = static_cast<std::size_t>(random.whole(0, static_cast<int>(trace.size())));
        Replay& replay = random.whole(0, 1) == 0 ? one : other;
        replay.go_to(n);
        Replay played(trace, every_part);
        played.go_to(n);
        expect_same_told(replay, played);
    }
}

TEST(Replay, GoesBackToTheSamePictureAsEveryStep) {
    const Trace trace = trace_of(scene_in(many_triangles(120)));
    ASSERT_GT(trace.size(), 100'000U); // several pictures
    expect_any_step(trace, Replay::usual_bytes, 40);
}

TEST(Replay, GoesBackInHardlyAnyMemory) {
    const Trace trace = trace_of(scene_in(many_triangles(120)));
    for (const std::size_t bytes : {1UL, 300'000UL, 1'000'000UL})
        expect_any_step(trace, bytes, 12);
}

TEST(Replay, KeepsPicturesFromWhenItFirstGoesBackAndToItsMemory) {
    const Trace trace = trace_of(scene_in(many_triangles(120)));
    Replay many(trace, every_part);
    Replay few(trace, every_part, 500'000);
    many.go_to(trace.size());
    EXPECT_EQ(many.bytes(), 0U);
    for (Replay* const replay : {&many, &few}) {
        replay->go_to(1);
        replay->go_to(0);
        for (std::size_t n = 0; n <= trace.size(); n += 10'000) {
            replay->go_to(n);
            EXPECT_LE(few.bytes(), 500'000U);
        }
    }
    EXPECT_GT(many.bytes(), 500'000U);
    EXPECT_LE(many.bytes(), Replay::usual_bytes);
    EXPECT_GT(few.interval(), many.interval());
}

TEST(Replay, OfRandomScenesGoesBackToTheSamePicture) {
    for (std::uint64_t seed = 0; seed < 50; ++seed)
        if (const auto scene = read_scene({"scene.json", RandomScene(seed).text()}))
            expect_any_step(trace_of(scene.value().scene), Replay::usual_bytes, 5);
}

} // namespace
} // namespace rastertrace
