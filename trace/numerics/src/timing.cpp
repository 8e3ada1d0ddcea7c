// SPDX-License-Identifier: MIT
#include <rastertrace/numerics/timing.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstddef>

namespace rastertrace {

namespace {

/// One of those that are measured.
struct State {
    int repetitions = 1;
    double spent = 0;                 ///< seconds of all its runs
    std::vector<double> seconds = {}; ///< of one repetition, in each run
};

/// Seconds that running it so often takes.
double seconds_of(const TimedRun& one, int repetitions, const Clock& clock) {
    const double start = clock();
    for (int i = 0; i < repetitions; ++i)
        one.run();
    return clock() - start;
}

/// Seconds of two runs. The faster one tells how long it takes: a single one may have been held up by
/// whatever else the machine does, or by memory that is touched for the first time.
std::vector<double> two_runs(const TimedRun& one, int repetitions, const TimingRules& rules,
                             const Clock& clock) {
    std::vector<double> seconds;
    for (int i = 0; i < std::min(2, rules.runs); ++i)
        seconds.push_back(seconds_of(one, repetitions, clock));
    return seconds;
}

/// Finds out how often it has to be repeated to be seen by the clock. This also fills the caches. What
/// takes all the time that it has is not run again: these runs are the ones that count.
State calibrated(const TimedRun& one, const TimingRules& rules, const Clock& clock) {
    State state;
    while (true) {
        const auto runs = two_runs(one, state.repetitions, rules, clock);
        const double seconds = *std::min_element(runs.begin(), runs.end());
        if (seconds >= rules.most_time) {
            for (const double run : runs)
                state.seconds.push_back(run / state.repetitions);
            return state;
        }
        if (seconds >= rules.shortest_run || state.repetitions >= 1 << 24)
            return state;
        const double factor = 1.25 * rules.shortest_run / std::max(seconds, 1e-9);
        state.repetitions = static_cast<int>(
            std::ceil(static_cast<double>(state.repetitions) * std::clamp(factor, 1.5, 100.0)));
    }
}

/// The middle one, or the mean of the two in the middle.
double median_of(std::vector<double> values) {
    std::sort(values.begin(), values.end());
    const std::size_t half = values.size() / 2;
    return values.size() % 2 == 1 ? values[half] : (values[half - 1] + values[half]) / 2;
}

} // namespace

double steady_clock_seconds() {
    const auto now = std::chrono::steady_clock::now().time_since_epoch();
    return std::chrono::duration<double>(now).count();
}

void time_in_turn(std::vector<TimedRun>& all, const TimingRules& rules,
                  const std::function<void(int, int)>& before_round, const Clock& clock) {
    std::vector<State> states;
    std::vector<std::size_t> to_run;
    for (const TimedRun& one : all) {
        states.push_back(calibrated(one, rules, clock));
        if (states.back().seconds.empty())
            to_run.push_back(states.size() - 1);
    }

    for (int round = 0; round < rules.runs; ++round) {
        if (before_round)
            before_round(round, rules.runs);
        for (std::size_t turn = 0; turn < to_run.size(); ++turn) {
            const std::size_t i = to_run[(turn + static_cast<std::size_t>(round)) % to_run.size()];
            State& state = states[i];
            if (state.spent >= rules.most_time && round >= least_runs)
                continue;
            const double seconds = seconds_of(all[i], state.repetitions, clock);
            state.spent += seconds;
            state.seconds.push_back(seconds / state.repetitions);
        }
    }

    for (std::size_t i = 0; i < all.size(); ++i) {
        const double nanoseconds = 1e9 / all[i].units;
        const auto& seconds = states[i].seconds;
        all[i].timing = {.minimum = nanoseconds * *std::min_element(seconds.begin(), seconds.end()),
                         .median = nanoseconds * median_of(seconds),
                         .runs = static_cast<int>(seconds.size())};
    }
}

} // namespace rastertrace
