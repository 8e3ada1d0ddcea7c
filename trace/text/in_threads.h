// SPDX-License-Identifier: MIT
#pragma once

// Work on many items in several threads. What comes of it must not depend on their order.
//
//     in_threads(items.size(), jobs, [&](std::size_t i) { results[i] = result_of(items[i]); });

#include <atomic>
#include <cstddef>
#include <thread>
#include <vector>

namespace rastertrace {

/// Calls `work(i)` once for each index below `count`, in `jobs` threads. `work` must not throw.
template <typename Work> void in_threads(std::size_t count, std::size_t jobs, const Work& work) {
    std::atomic<std::size_t> next = 0;
    const auto work_on = [&] {
        for (std::size_t i = next++; i < count; i = next++)
            work(i);
    };
    std::vector<std::jthread> threads;
    for (std::size_t i = 1; i < jobs; ++i)
        threads.emplace_back(work_on);
    work_on();
}

} // namespace rastertrace
