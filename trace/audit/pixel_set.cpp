// SPDX-License-Identifier: MIT
#include "pixel_set.h"

#include <algorithm>
#include <numeric>

namespace rastertrace {

PixelSet::PixelSet(std::vector<std::uint32_t> offsets) {
    if (!std::is_sorted(offsets.begin(), offsets.end()))
        std::sort(offsets.begin(), offsets.end());
    offsets.erase(std::unique(offsets.begin(), offsets.end()), offsets.end());
    const auto goes_on = [](std::uint32_t run, std::uint32_t offset) {
        return last_of(run) + 1 == offset && more_in(run) < most_more;
    };
    std::vector<std::uint32_t> runs;
    for (const std::uint32_t offset : offsets)
        if (!runs.empty() && goes_on(runs.back(), offset))
            ++runs.back();
        else
            runs.push_back(offset << bits_of_more);
    runs_ = runs; // of the exact size
}

std::size_t PixelSet::size() const {
    return std::accumulate(
        runs_.begin(), runs_.end(), std::size_t{0},
        [](std::size_t sum, std::uint32_t run) { return sum + more_in(run) + 1; });
}

PixelSet::Iterator PixelSet::not_before(std::uint32_t offset) const {
    const auto run =
        std::lower_bound(runs_.begin(), runs_.end(), offset,
                         [](std::uint32_t one, std::uint32_t at) { return last_of(one) < at; });
    if (run == runs_.end())
        return end();
    return {&*run, offset - std::min(offset, first_of(*run))};
}

bool PixelSet::contains(std::uint32_t offset) const {
    const Iterator found = not_before(offset);
    return found != end() && *found == offset;
}

} // namespace rastertrace
