// SPDX-License-Identifier: MIT
#pragma once

// Two replays that have gone different ways to one step.
//
//     expect_same(scanned, played);

#include <rastertrace/trace/record/replay.h>

#include <gtest/gtest.h>

#include <algorithm>

namespace rastertrace {

/// Everything that is remembered of the steps so far.
inline void expect_same(const Replay& one, const Replay& other) {
    EXPECT_EQ(one.step(), other.step());
    EXPECT_TRUE(one.frame().image.colors() == other.frame().image.colors());
    EXPECT_TRUE(one.frame().drawn_by == other.frame().drawn_by);
    EXPECT_TRUE(one.frame().writes == other.frame().writes);
    EXPECT_TRUE(one.frame().stored_by == other.frame().stored_by);
    EXPECT_EQ(one.primitive(), other.primitive());
    EXPECT_EQ(one.scanline(), other.scanline());
    EXPECT_EQ(one.scanline_before(), other.scanline_before());
    EXPECT_TRUE(std::ranges::equal(one.primitives(), other.primitives()));
    EXPECT_TRUE(std::ranges::equal(one.matrices(), other.matrices()));
    EXPECT_TRUE(std::ranges::equal(one.edges(), other.edges()));
    EXPECT_EQ(one.order(), other.order());
    EXPECT_EQ(one.ray(), other.ray());
    EXPECT_EQ(one.color(), other.color());
    EXPECT_EQ(one.vertex_before(), other.vertex_before());
    EXPECT_EQ(one.stored_before(), other.stored_before());
    EXPECT_EQ(one.drew_over(), other.drew_over());
}

} // namespace rastertrace
