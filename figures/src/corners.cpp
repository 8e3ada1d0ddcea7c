// SPDX-License-Identifier: MIT
#include <rastertrace/figures/corners.h>

namespace rastertrace {

std::vector<Point> corners_of(const StepView& primitive) {
    std::vector<Point> corners;
    for (const auto& at : primitive.text_rows("at")) {
        const auto x = at.size() < 2 ? std::nullopt : nearest_double_in(at[0]);
        const auto y = at.size() < 2 ? std::nullopt : nearest_double_in(at[1]);
        if (!x || !y)
            return {};
        corners.push_back({*x, *y});
    }
    return corners;
}

} // namespace rastertrace
