// SPDX-License-Identifier: MIT
// What a terminal shows of long work; terminal.sh has it shown on one.

#include "app/progress.h"

#include <gtest/gtest.h>

namespace rastertrace {
namespace {

TEST(ProgressLine, HasTheRateAndTheTimeThatIsLeft) {
    const LongWork scenes{
        .doing = "fuzz", .unit = "scenes", .total = 1000, .done = [] { return 0; }};
    EXPECT_EQ(progress_line(scenes, 120, 4), "fuzz: 120 of 1000 scenes, 30 a second, 29 s left");
    EXPECT_EQ(progress_line(scenes, 1, 4), "fuzz: 1 of 1000 scenes, 0.2 a second, 67 min left");
    EXPECT_EQ(progress_line(scenes, 0, 4), "fuzz: 0 of 1000 scenes, 0 a second");
    EXPECT_EQ(progress_line(scenes, 1000, 4), "fuzz: 1000 of 1000 scenes, 250 a second");
}

TEST(ProgressLine, IsInLargeUnits) {
    const LongWork bytes{.doing = "trace",
                         .unit = "MB written",
                         .done = [] { return 0; },
                         .one_unit = bytes_in_a_megabyte};
    EXPECT_EQ(progress_line(bytes, 1'250'000'000, 10), "trace: 1250 MB written, 125 a second");
    EXPECT_EQ(progress_line(bytes, 2'500'000, 1), "trace: 2.5 MB written, 2.5 a second");
    EXPECT_EQ(progress_line({.doing = "looking for cliffs"}, 0, 3), "looking for cliffs");
}

} // namespace
} // namespace rastertrace
