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

/// The number of threads that was asked for; if that is 0, as many as run at once.
inline std::size_t jobs_or_usual(std::size_t jobs) {
    return jobs == 0 ? usual_jobs() : jobs;
}

/// Calls `work(i, thread)` once for each index i below `end`, in `jobs` threads, numbered from 0; a thread takes `at_once`
/// neighboring indices at a time. `work` must not throw. It may lower `end`: then no index from there on
/// is begun. The module for pages has one thread.
template <typename Work>
void in_threads(const std::atomic<std::size_t>& end, [[maybe_unused]] std::size_t jobs,
                const Work& work, std::size_t at_once = 1) {
    std::atomic<std::size_t> next = 0;
    const auto work_on = [&](std::size_t thread) {
        for (std::size_t first = next.fetch_add(at_once); first < end;
             first = next.fetch_add(at_once))
            for (std::size_t i = first; i < first + at_once && i < end; ++i)
                work(i, thread);
    };
#ifndef __EMSCRIPTEN__
    std::vector<std::jthread> threads;
    const std::size_t turns = (end + at_once - 1) / at_once;
    for (std::size_t i = 1; i < std::min(jobs, turns); ++i)
        threads.emplace_back(work_on, i);
#endif
    work_on(0);
}

/// The same for each index below a number that stays.
template <typename Work>
void in_threads(std::size_t count, std::size_t jobs, const Work& work, std::size_t at_once = 1) {
    const std::atomic<std::size_t> end = count;
    in_threads(end, jobs, work, at_once);
}

} // namespace rastertrace
