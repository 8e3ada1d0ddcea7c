// SPDX-License-Identifier: MIT
// Lines as rastertrace writes them, which are read quickly, lead where a replay of every step leads.

#include "random_choice.h"
#include "random_scene.h"
#include "same_replay.h"
#include "traces.h"

#include <rastertrace/trace/record/replay.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdint>
#include <string>
#include <string_view>

namespace rastertrace {
namespace {

constexpr FrameParts all_parts{.writes = true, .depths = true};

/// A trace with a blank in front of some of its steps, or of all: a reader of JSON reads those.
std::string with_blanks(std::string_view text, Random& random, int one_of) {
    std::string changed;
    while (!text.empty()) {
        const std::size_t line = std::min(text.find('\n'), text.size() - 1) + 1;
        if (text.starts_with(R"({"step")") && random.chance(one_of))
            changed += ' ';
        changed += text.substr(0, line);
        text.remove_prefix(line);
    }
    return changed;
}

TEST(PlainLines, LeadWhereEveryStepLeads) {
    int traces = 0;
    for (std::uint64_t seed = 1; seed <= 300; ++seed) {
        const auto scene = read_scene({"scene.json", RandomScene(seed).text()});
        if (!scene)
            continue;
        Random random(seed);
        const bool is_document = random.chance(2);
        const std::string text = trace_text(
            scene.value(),
            {.layout = is_document ? TraceLayout::json : TraceLayout::jsonl, .filter = {}});
        const Trace quick = readable_trace(text);
        const Trace thorough = readable_trace(with_blanks(text, random, 1));
        const Trace mixed = readable_trace(with_blanks(text, random, 20));
        ASSERT_EQ(mixed.size(), thorough.size());
        ASSERT_EQ(quick.size(), thorough.size());
        if (thorough.size() == 0)
            continue;
        ++traces;

        // The end that the readers know, and that of every step played.
        Replay known(thorough, all_parts);
        known.go_to(thorough.size());
        Replay mixed_end(mixed, all_parts);
        mixed_end.go_to(mixed.size());
        Replay played(thorough, all_parts);
        for (std::size_t n = 1; n <= thorough.size(); ++n)
            played.go_to(n);
        expect_same(known, played);
        expect_same(mixed_end, played);

        Replay quick_end(quick, all_parts);
        quick_end.go_to(quick.size());
        expect_same(quick_end, played);
        for (std::size_t n = 1; n <= quick.size(); ++n) {
            ASSERT_TRUE(quick.is_plain(n));
            for (const Trace* const one : {&quick, &mixed}) {
                ASSERT_EQ(one->step(n).json(), thorough.step(n).json());
                ASSERT_EQ(one->kind_of(n), thorough.kind_of(n));
            }
        }
        if (HasFailure())
            FAIL() << "seed " << seed;
    }
    EXPECT_GT(traces, 200);
}

// Whatever stands between them: a line that is written otherwise is a step, or is refused, as it is by itself.
TEST(PlainLines, EndInFrontOfAnyOtherLine) {
    const std::string header = R"({"rastertrace":1,"canvas":{"width":8,"height":8}})"
                               "\n";
    const std::string step = R"({"step":"pixel","x":1,"y":2})"
                             "\n";
    const auto read_with = [&](const std::string& other) {
        return read_trace({"t.jsonl", header + step + step + other + step + "{\"end\":{}}\n"});
    };
    EXPECT_EQ(read_with("\n").value().size(), 3U);
    for (const std::string& other : {" " + step, std::string("{\"step\":\"none\"}\n")}) {
        const auto read = read_with(other);
        const Trace& trace = read.value();
        ASSERT_EQ(trace.size(), 4U);
        for (std::size_t n = 1; n <= 4; ++n)
            EXPECT_EQ(trace.is_plain(n), n != 3) << other;
    }
    for (const std::string& other :
         {std::string("{\"step\":\"pixel\",\"x\":1}\n"), std::string("],\n")})
        EXPECT_EQ(read_with(other).problem().line, 4U) << other;
}

// A zero byte is told first, wherever it is, as long as what stands before it is a trace.
TEST(PlainLines, HaveNoZeroByte) {
    const std::string text =
        trace_text(scene_in(R"({"vertices":{"A":[1,2]},"points":["A"]})"), in_lines);
    for (std::size_t at = 0; at < text.size(); ++at) {
        std::string damaged = text;
        damaged[at] = '\0';
        const auto read = read_trace({"trace.jsonl", damaged});
        ASSERT_FALSE(read) << at;
        EXPECT_NE(read.problem().message.find("zero byte"), std::string::npos)
            << at << ": " << read.problem().message;
    }
}

} // namespace
} // namespace rastertrace
