// SPDX-License-Identifier: MIT
#include "grays.h"

#include <algorithm>
#include <cmath>

namespace rastertrace {

Color gray(double share) {
    constexpr double darkest = 120;
    constexpr double lightest = 250;
    const auto level = static_cast<std::uint8_t>(
        std::lround(darkest + std::clamp(share, 0.0, 1.0) * (lightest - darkest)));
    return {level, level, level};
}

double share_of_writes(std::uint32_t writes) {
    const std::uint32_t told = std::min(writes, most_writes_told);
    return 1 - (told - 1) / (most_writes_told - 1.0);
}

} // namespace rastertrace
