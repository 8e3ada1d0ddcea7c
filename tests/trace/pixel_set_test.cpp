// SPDX-License-Identifier: MIT
// A PixelSet has the pixels that it was given.

#include "random_choice.h"

#include <rastertrace/trace/audit/pixel_set.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdint>
#include <set>
#include <vector>

namespace rastertrace {
namespace {

constexpr int most_pixels = 1 << 26; // of a canvas

/// Runs of some lengths, here and there, from `first` on.
std::set<std::uint32_t> random_pixels(Random& random, int first) {
    std::set<std::uint32_t> pixels;
    for (int place = first; place < most_pixels && pixels.size() < 1000;
         place += random.whole(1, 300))
        for (int left = random.whole(1, 200); left > 0 && place < most_pixels; --left, ++place)
            pixels.insert(static_cast<std::uint32_t>(place));
    return pixels;
}

TEST(PixelSet, HasThePixelsThatItWasGiven) {
    Random random(1);
    for (int i = 0; i < 200; ++i) {
        const int first = random.pick({0, 1, random.whole(0, 5000), most_pixels - 1500});
        const auto pixels = random_pixels(random, first);
        const PixelSet set(std::vector<std::uint32_t>(pixels.begin(), pixels.end()));
        ASSERT_FALSE(set.empty());
        EXPECT_EQ(set.size(), pixels.size());
        EXPECT_EQ(set.front(), *pixels.begin());
        EXPECT_EQ(set.back(), *pixels.rbegin());
        EXPECT_TRUE(std::equal(set.begin(), set.end(), pixels.begin(), pixels.end()));
        const auto place = [&] {
            return static_cast<std::uint32_t>(
                std::clamp(first + random.whole(-5, 3000), 0, most_pixels));
        };
        for (int question = 0; question < 50; ++question) {
            const std::uint32_t at = place();
            EXPECT_EQ(set.contains(at), pixels.contains(at)) << at;
            const auto [from, to] = std::minmax({at, place()});
            const auto part = set.part(from, to);
            EXPECT_TRUE(std::equal(part.begin(), part.end(), pixels.lower_bound(from),
                                   pixels.lower_bound(to)))
                << from << ", " << to;
        }
        ASSERT_FALSE(HasFailure());
    }
    EXPECT_TRUE(PixelSet().empty());
    EXPECT_FALSE(PixelSet().contains(0));
    EXPECT_EQ(PixelSet().begin(), PixelSet().end());
}

} // namespace
} // namespace rastertrace
