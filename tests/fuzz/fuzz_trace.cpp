// SPDX-License-Identifier: MIT
// Any bytes as a trace: what is wrong with them is said safely, and a trace that can be read,
// damaged or not, can be replayed, described and counted.

#include "check.h"

#include <rastertrace/trace/audit/stats.h>
#include <rastertrace/trace/record/replay.h>
#include <rastertrace/trace/record/trace.h>
#include <rastertrace/trace/record/write_trace.h>
#include <rastertrace/trace/tell/describe.h>

#include <cstddef>
#include <cstdint>

namespace rastertrace::fuzz {

namespace {

/// The most steps that are replayed.
constexpr std::size_t most_steps = 256;

void replay_and_count(const Trace& trace) {
    Replay replay(trace);
    for (std::size_t n = 0; n <= trace.size(); ++n) {
        replay.go_to(n);
        check_description(describe_step(replay));
    }

    const Stats stats = stats_of(trace);
    check(stats.steps == trace.size(), "the stats count other steps than there are");
    check(stats.pixels <= stats.canvas, "the stats count more pixels than the canvas has");
    check(stats.frame == frame_name(replay.frame().image), "the stats name another picture");
}

} // namespace

} // namespace rastertrace::fuzz

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    using namespace rastertrace;
    const auto trace = read_trace(fuzz::source_of("fuzz.trace.json", data, size));
    if (!trace) {
        fuzz::check_message(trace.problem());
        return 0;
    }
    for (const Problem& damage : trace.value().damage)
        fuzz::check_message(damage);
    if (fuzz::is_small(trace.value().canvas) && trace.value().size() <= fuzz::most_steps)
        fuzz::replay_and_count(trace.value());
    return 0;
}
