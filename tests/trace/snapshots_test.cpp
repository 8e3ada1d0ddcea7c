// SPDX-License-Identifier: MIT
// A replay that goes by kept pictures is the one that plays every step.

#include "random_choice.h"
#include "random_scene.h"
#include "same_replay.h"
#include "traces.h"

#include <rastertrace/trace/record/snapshots.h>
#include <rastertrace/trace/tell/describe.h>

#include <gtest/gtest.h>

#include <cstdint>
#include <string>

namespace rastertrace {
namespace {

constexpr FrameParts all_parts{.writes = true, .depths = true};

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

/// Random moves by kept pictures in so many bytes, each against a replay that plays every step.
void expect_any_step(const Trace& trace, std::size_t bytes, int moves) {
    Snapshots snapshots(trace, all_parts, bytes);
    while (snapshots.read_on(9'999)) {
    }
    ASSERT_EQ(snapshots.reach(), trace.size());
    Replay replay(trace, all_parts);
    Random random(trace.size());
    for (int i = 0; i < moves; ++i) {
        const auto n = static_cast<std::size_t>(random.whole(0, static_cast<int>(trace.size())));
        snapshots.go_to(replay, n);
        Replay played(trace, all_parts);
        played.go_to(n);
        expect_same_told(replay, played);
    }
}

TEST(Snapshots, LeadToTheSamePictureAsEveryStep) {
    const Trace trace = trace_of(scene_in(many_triangles(120)));
    ASSERT_GT(trace.size(), 100'000U); // several pictures
    expect_any_step(trace, Snapshots::usual_bytes, 40);
}

TEST(Snapshots, LeadThereInHardlyAnyMemory) {
    const Trace trace = trace_of(scene_in(many_triangles(120)));
    for (const std::size_t bytes : {1UL, 300'000UL, 1'000'000UL})
        expect_any_step(trace, bytes, 12);
}

TEST(Snapshots, KeepToTheirMemory) {
    const Trace trace = trace_of(scene_in(many_triangles(120)));
    Snapshots many(trace, all_parts);
    Snapshots few(trace, all_parts, 500'000);
    while (many.read_on(50'000) && few.read_on(50'000)) {
        EXPECT_LE(many.bytes(), Snapshots::usual_bytes);
        EXPECT_LE(few.bytes(), 500'000U);
    }
    EXPECT_GT(few.interval(), many.interval());
}

TEST(Snapshots, OfRandomScenesLeadToTheSamePicture) {
    for (std::uint64_t seed = 0; seed < 50; ++seed)
        if (const auto scene = read_scene({"scene.json", RandomScene(seed).text()}))
            expect_any_step(trace_of(scene.value().scene), Snapshots::usual_bytes, 5);
}

} // namespace
} // namespace rastertrace
