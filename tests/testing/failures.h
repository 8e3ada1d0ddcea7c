// SPDX-License-Identifier: MIT
#pragma once

// What a test says that fails, as text:
//
//     EXPECT_EQ(failures_of([&] { EXPECT_THAT(trace, PlotsPixel(4, 2)); }), "...");

#include <gtest/gtest-spi.h>
#include <gtest/gtest.h>

#include <string>

namespace rastertrace {

/// The messages of all failures in `test`, one after the other.
template <typename Test> std::string failures_of(Test&& test) {
    ::testing::TestPartResultArray failures;
    {
        const ::testing::ScopedFakeTestPartResultReporter reporter(
            ::testing::ScopedFakeTestPartResultReporter::INTERCEPT_ONLY_CURRENT_THREAD, &failures);
        test();
    }
    std::string text;
    for (int i = 0; i < failures.size(); ++i)
        text += std::string(failures.GetTestPartResult(i).message()) + "\n";
    return text;
}

} // namespace rastertrace
