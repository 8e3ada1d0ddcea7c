// SPDX-License-Identifier: MIT
#pragma once

// How long something takes, beside others that do the same work: all are run in turn, again and
// again, so that a machine that is busy for a while is busy for all of them.
//
//     std::vector<TimedRun> runs{{.run = [&] { keep(sum(numbers)); }, .units = 1000}};
//     time_in_turn(runs, {});
//     runs[0].timing.median;  // ns for each of the 1000

#include <functional>
#include <vector>

namespace rastertrace {

/// How thoroughly to measure.
struct TimingRules {
    int runs = 20;              ///< of each
    double shortest_run = 5e-4; ///< seconds; what is shorter is repeated until it takes so long
    double most_time = 2;       ///< seconds for one of them; what takes longer is run less often
};

/// However long its runs take, each is run so often, unless a single run takes all the time allowed: of
/// three, the one that something else held up is neither the minimum nor the median.
inline constexpr int least_runs = 3;

/// What was measured, in nanoseconds per unit.
struct Timing {
    double minimum = 0;
    double median = 0;
    int runs = 0;
};

/// Something to measure. `run` does the whole work once, `units` says how much that is.
struct TimedRun {
    std::function<void()> run;
    double units = 1;
    Timing timing = {};
};

/// Seconds since whenever.
using Clock = std::function<double()>;
double steady_clock_seconds();

/// Runs all of them in turn, beginning with another one in each round, and fills in their timings.
/// `before_round` is called with the number of each round and how many there will be.
void time_in_turn(std::vector<TimedRun>& all, const TimingRules& rules,
                  const std::function<void(int, int)>& before_round = {},
                  const Clock& clock = steady_clock_seconds);

/// Makes the compiler believe that somebody reads `value`, and everything in memory.
template <typename T> void keep(const T& value) {
    asm volatile("" : : "g"(&value) : "memory");
}

} // namespace rastertrace
