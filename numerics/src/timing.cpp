// SPDX-License-Identifier: MIT
#include <rastertrace/numerics/timing.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstddef>

namespace rastertrace {

namespace {

/// Seconds that running it so often takes.
double seconds_of(const TimedRun& one, int repetitions) {
    using Clock = std::chrono::steady_clock;
    const auto start = Clock::now();
    for (int i = 0; i < repetitions; ++i)
        one.run();
    return std::chrono::duration<double>(Clock::now() - start).count();
}

/// The middle one, or the mean of the two in the middle.
double median_of(std::vector<double> values) {
    std::sort(values.begin(), values.end());
    const std::size_t half = values.size() / 2;
    return values.size() % 2 == 1 ? values[half] : (values[half - 1] + values[half]) / 2;
}

} // namespace

void time_in_turn(std::vector<TimedRun>& all, const TimingRules& rules,
                  const std::function<void(int, int)>& before_round) {
    struct State {
        int repetitions = 1;
        double spent = 0;            ///< seconds of all its runs
        std::vector<double> seconds; ///< of one repetition
    };
    std::vector<State> states(all.size());

    // How often each has to be repeated to be seen by the clock. This also fills the caches.
    for (std::size_t i = 0; i < all.size(); ++i) {
        State& state = states[i];
        double seconds = seconds_of(all[i], 1);
        while (seconds < rules.shortest_run && state.repetitions < 1 << 24) {
            const double factor = 1.25 * rules.shortest_run / std::max(seconds, 1e-9);
            state.repetitions = static_cast<int>(
                std::ceil(static_cast<double>(state.repetitions) * std::clamp(factor, 1.5, 100.0)));
            seconds = seconds_of(all[i], state.repetitions);
        }
        // What takes so long that it is run only once has been.
        if (seconds >= rules.most_time) {
            state.spent = seconds;
            state.seconds.push_back(seconds / state.repetitions);
        }
    }

    for (int round = 0; round < rules.runs; ++round) {
        if (before_round)
            before_round(round, rules.runs);
        for (std::size_t turn = 0; turn < all.size(); ++turn) {
            const std::size_t i = (turn + static_cast<std::size_t>(round)) % all.size();
            State& state = states[i];
            if (state.spent >= rules.most_time)
                continue;
            const double seconds = seconds_of(all[i], state.repetitions);
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
