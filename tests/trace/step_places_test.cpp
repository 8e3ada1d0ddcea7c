// SPDX-License-Identifier: MIT
// Steps are found by their kind as a walk through all of them finds them, and a walk through a mapped file leaves little of
// the file in memory.

#include "random_choice.h"
#include "random_scene.h"
#include "traces.h"

#include <rastertrace/trace/record/trace.h>
#include <rastertrace/trace/text/input.h>

#include <gtest/gtest.h>
#include <unistd.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <fstream>
#include <sstream>
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

TEST(StepPlaces, TheNextStepOfAKindIsTheOneThatAWalkComesTo) {
    std::size_t steps = 0;
    for (std::uint64_t seed = 1; seed <= 100; ++seed) {
        const auto scene = read_scene({"scene.json", RandomScene(seed).text()});
        if (!scene)
            continue;
        Random random(seed);
        const std::string text = trace_text(scene.value(), in_lines);
        const auto& [drawn, plan, notes] = scene.value();
        for (const Trace& trace : {readable_trace(text), readable_trace(foreign(text, random)),
                                   std::move(read_written_trace({"trace.json", text}).value()),
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

/// How much of the mapped file that holds `byte` is in memory.
std::size_t resident_around(const char* byte) {
    const auto place = reinterpret_cast<std::uintptr_t>(byte);
    std::ifstream maps("/proc/self/smaps");
    bool is_there = false;
    for (std::string line; std::getline(maps, line);) {
        std::istringstream fields(line);
        std::uintptr_t begin = 0;
        std::uintptr_t end = 0;
        char dash = 0;
        if (fields >> std::hex >> begin >> dash >> end && dash == '-')
            is_there = begin <= place && place < end;
        else if (is_there && line.starts_with("Rss:"))
            return std::stoul(line.substr(line.find_first_of("0123456789"))) * 1024;
    }
    ADD_FAILURE() << "expected a mapped file";
    return 0;
}

TEST(StepPlaces, AWalkThroughAMappedFileLeavesLittleOfItInMemory) {
    const auto path = std::filesystem::path(testing::TempDir()) /
                      ("walked." + std::to_string(::getpid()) + ".jsonl");
    {
        std::ofstream file(path);
        file << R"({"rastertrace":1,"canvas":{"width":8,"height":8,"origin":"top-left"}})" << '\n';
        for (int i = 0; i < 1'000'000; ++i)
            file << R"({"step":"pixel","x":1,"y":2})" << '\n';
        file << R"({"end":{"steps":1000000}})" << '\n';
    }
    const std::size_t size = std::filesystem::file_size(path);
    auto source = read_source(path.string(), {});
    std::filesystem::remove(path);
    ASSERT_TRUE(source);
    const auto trace = read_trace(std::move(source.value()));
    ASSERT_TRUE(trace);
    ASSERT_EQ(trace.value().size(), 1'000'000U);
    std::size_t bytes = 0;
    for (std::size_t n = 1; n <= trace.value().size(); ++n)
        bytes += static_cast<std::size_t>(trace.value().step(n).json().back() == '}');
    EXPECT_EQ(bytes, 1'000'000U);
    EXPECT_GT(size, 25'000'000U);
    const StepView first = trace.value().step(1);
    EXPECT_LT(resident_around(first.json().data()), 9'000'000U);
}

} // namespace
} // namespace rastertrace
