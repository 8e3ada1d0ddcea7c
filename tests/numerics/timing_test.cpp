// SPDX-License-Identifier: MIT
// Timing, by a clock that stands still but for what the runs say that they take: whatever else the machine
// does, these tests see the same.

#include <rastertrace/numerics/timing.h>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cstddef>
#include <vector>

namespace rastertrace {
namespace {

using testing::ElementsAre;

/// A clock, and runs that move its hands.
class TimingByHand : public testing::Test {
protected:
    /// A run that takes `seconds`, except that its nth call takes what `held_up` says for it.
    struct HeldUp {
        std::size_t call;
        double seconds;
    };
    TimedRun run_of(double seconds, std::vector<HeldUp> held_up = {}) {
        const std::size_t number = calls_.size();
        calls_.push_back(0);
        return {.run =
                    [this, seconds, held_up, number] {
                        double takes = seconds;
                        for (const HeldUp& one : held_up)
                            if (one.call == calls_[number])
                                takes = one.seconds;
                        ++calls_[number];
                        now_ += takes;
                        order_.push_back(number);
                    },
                .units = 1};
    }

    std::vector<TimedRun> timed(std::vector<TimedRun> all, const TimingRules& by) {
        time_in_turn(all, by, {}, [this] { return now_; });
        return all;
    }

    static constexpr double nanosecond = 1e-9;
    static constexpr TimingRules rules{.runs = 20, .shortest_run = 1e-3, .most_time = 2};

    double now_ = 100;
    std::vector<std::size_t> calls_;
    std::vector<std::size_t> order_;
};

// What stood in a report: 7170 ns for a setting whose neighbors took 1.8.
TEST_F(TimingByHand, OneSlowFirstCallIsNotTakenForTheTruth) {
    const auto timing = timed({run_of(1.8e-6, {{0, 7.17}})}, rules)[0].timing;
    EXPECT_EQ(timing.runs, 20);
    EXPECT_NEAR(timing.minimum, 1800, 1e-3);
    EXPECT_NEAR(timing.median, 1800, 1e-3);
    EXPECT_GE(calls_[0], 20U * 555) << "it is repeated as often as one that was never held up";
}

TEST_F(TimingByHand, ARunThatIsHeldUpDoesNotEndTheOthers) {
    // Two calls to calibrate with; then the first run that counts is held up.
    const auto timing = timed({run_of(0.01, {{2, 5}})}, rules)[0].timing;
    EXPECT_EQ(timing.runs, least_runs);
    EXPECT_NEAR(timing.minimum, 0.01 / nanosecond, 1);
    EXPECT_NEAR(timing.median, 0.01 / nanosecond, 1);
}

TEST_F(TimingByHand, WhatTakesAllTheTimeIsRunTwiceAndBothCount) {
    const auto timing = timed({run_of(3, {{1, 5}})}, rules)[0].timing;
    EXPECT_EQ(calls_[0], 2U);
    EXPECT_EQ(timing.runs, 2);
    EXPECT_NEAR(timing.minimum, 3 / nanosecond, 1);
    EXPECT_NEAR(timing.median, 4 / nanosecond, 1);
}

TEST_F(TimingByHand, WhatTakesMostOfTheTimeIsRunThreeTimes) {
    EXPECT_EQ(timed({run_of(1.9)}, rules)[0].timing.runs, least_runs);
    EXPECT_EQ(calls_[0], 2U + least_runs);
}

TEST_F(TimingByHand, RunsEndWhenTheTimeIsSpent) {
    EXPECT_EQ(timed({run_of(0.3)}, rules)[0].timing.runs, 7) << "the seventh ends after 2.1 s";
}

TEST_F(TimingByHand, WhatIsShortIsRepeatedUntilTheClockSeesIt) {
    const auto all = timed({run_of(3e-6)}, rules);
    EXPECT_NEAR(all[0].timing.median, 3000, 1e-3);
    EXPECT_EQ(all[0].timing.runs, rules.runs);
    EXPECT_GE((now_ - 100) / rules.runs, rules.shortest_run);
}

TEST_F(TimingByHand, AllAreRunInTurnBeginningWithAnotherOneInEachRound) {
    timed({run_of(0.01), run_of(5), run_of(0.01)}, {.runs = 3, .shortest_run = 0, .most_time = 1});
    const std::vector<std::size_t> counted(order_.begin() + 6, order_.end());
    EXPECT_THAT(counted, ElementsAre(0, 2, 2, 0, 0, 2)) << "the second one has had its runs";
}

TEST_F(TimingByHand, WhereOneRunIsAskedForThereIsOne) {
    EXPECT_EQ(timed({run_of(0.5)}, {.runs = 1, .shortest_run = 0, .most_time = 0})[0].timing.runs,
              1);
    EXPECT_EQ(calls_[0], 1U);
}

TEST(SteadyClock, NeverRunsBackward) {
    double before = steady_clock_seconds();
    for (int i = 0; i < 1000; ++i) {
        const double now = steady_clock_seconds();
        EXPECT_GE(now, before);
        before = now;
    }
}

} // namespace
} // namespace rastertrace
