// SPDX-License-Identifier: MIT
#pragma once

// Work on many items in several threads. What comes of it must not depend on their order.
//
//     in_threads(items.size(), jobs, [&](std::size_t i, std::size_t) { results[i] = result_of(items[i]); });

#include <algorithm>
#include <atomic>
#include <cstddef>
#include <thread>
#include <vector>

namespace rastertrace {

/// As many threads as run at once.
inline std::size_t usual_jobs() {
    return std::max(1U, std::thread::hardware_concurrency());
}

/// Calls `work(i, thread)` once for each index i below `end`, in `jobs` threads, numbered from 0. `work` must not throw.
/// It may lower `end`: then no index from there on is begun.
template <typename Work>
void in_threads(const std::atomic<std::size_t>& end, std::size_t jobs, const Work& work) {
    std::atomic<std::size_t> next = 0;
    const auto work_on = [&](std::size_t thread) {
        for (std::size_t i = next++; i < end; i = next++)
            work(i, thread);
    };
    std::vector<std::jthread> threads;
    for (std::size_t i = 1; i < std::min<std::size_t>(jobs, end); ++i)
        threads.emplace_back(work_on, i);
    work_on(0);
}

/// The same for each index below a number that stays.
template <typename Work> void in_threads(std::size_t count, std::size_t jobs, const Work& work) {
    const std::atomic<std::size_t> end = count;
    in_threads(end, jobs, work);
}

} // namespace rastertrace
