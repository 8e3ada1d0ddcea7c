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

void DepthGrays::include(double depth) {
    least_ = std::min(least_.value_or(depth), depth);
    largest_ = std::max(largest_.value_or(depth), depth);
}

int DepthGrays::level_of(std::optional<double> depth) const {
    const double range = least_ ? *largest_ - *least_ : 0;
    const double share = depth && range > 0 ? (*depth - *least_) / range : 1;
    return gray(larger_is_nearer_.value_or(false) ? share : 1 - share).red();
}

double share_of_writes(std::uint32_t writes) {
    const std::uint32_t told = std::min(writes, most_writes_told);
    return 1 - (told - 1) / (most_writes_told - 1.0);
}

} // namespace rastertrace
