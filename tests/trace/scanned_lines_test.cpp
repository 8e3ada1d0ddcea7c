// SPDX-License-Identifier: MIT
// Lines that are scanned in parts lead where a replay of every step leads.

#include "random_choice.h"
#include "random_scene.h"
#include "same_replay.h"
#include "traces.h"

#include <rastertrace/trace/record/frame.h>
#include <rastertrace/trace/record/scanned_lines.h>
#include <rastertrace/trace/record/step_places.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

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

/// Places where lines with steps begin, the first and some others; and where the last such line ends.
std::vector<std::size_t> parts_of(std::string_view text, Random& random) {
    std::vector<std::size_t> parts;
    std::size_t end = 0;
    for (std::size_t at = 0; at < text.size(); at = text.find('\n', at) + 1) {
        if (!text.substr(at).starts_with(R"({"step")"))
            continue;
        if (parts.empty() || random.chance(9))
            parts.push_back(at);
        end = text.find('\n', at) + 1;
    }
    parts.push_back(end);
    return parts;
}

TEST(ScannedLines, LeadWhereEveryStepLeads) {
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
        const Trace thorough = readable_trace(with_blanks(text, random, 1));
        const Trace mixed = readable_trace(with_blanks(text, random, 20));
        ASSERT_EQ(mixed.size(), thorough.size());
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

        ReplayState scanned(thorough.canvas, all_parts);
        StepPlaces places;
        StepCounts counts;
        const auto parts = parts_of(text, random);
        for (std::size_t i = 0; i + 1 < parts.size(); ++i) {
            const auto lines = scan_lines(text, parts[i], parts[i + 1],
                                          {.canvas = thorough.canvas, .is_document = is_document});
            ASSERT_EQ(lines.measured.end, parts[i + 1]) << text.substr(lines.measured.end, 200);
            lines.play(scanned);
            places.add_lines(lines.measured);
            counts += lines.counts;
        }
        expect_same(scanned, played);
        ASSERT_EQ(places.size(), thorough.size());
        for (std::size_t n = 1; n <= places.size(); ++n) {
            const StepPlace place = places.at(n, text);
            ASSERT_EQ(text.substr(place.offset, place.length), thorough.step(n).json());
            ASSERT_EQ(places.kind(n, text), thorough.kind_of(n));
            ASSERT_EQ(mixed.step(n).json(), thorough.step(n).json());
            ASSERT_EQ(mixed.kind_of(n), thorough.kind_of(n));
        }
        for (const auto& [name, count] : thorough.end->count)
            EXPECT_EQ(counts.of(name), count) << name;
        if (HasFailure())
            FAIL() << "seed " << seed;
    }
    EXPECT_GT(traces, 200);
}

// What is scanned ends in front of the first line that is written otherwise.
TEST(ScannedLines, EndInFrontOfAnyOtherLine) {
    const std::string step = R"({"step":"pixel","x":1,"y":2})"
                             "\n";
    for (const std::string& other :
         {std::string("\n"), " " + step, std::string("{\"step\":\"pixel\",\"x\":1}\n"),
          std::string("{\"step\":\"none\"}\n"), std::string("],\n"), std::string("\0\n", 2)}) {
        const std::string text = step + step + other + step;
        const auto lines = scan_lines(text, 0, text.size(), {.canvas = Canvas{8, 8}});
        EXPECT_EQ(lines.measured.kinds.size(), 2U) << other;
        EXPECT_EQ(lines.measured.end, 2 * step.size());
    }
}

// A zero byte is told first, wherever it is, as long as what stands before it is a trace.
TEST(ScannedLines, HaveNoZeroByte) {
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
