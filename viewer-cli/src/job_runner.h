// SPDX-License-Identifier: MIT
#pragma once

// Many jobs, several at once: runs of a program on random scenes. What comes of them must not
// depend on their order.
//
//     JobRunner runner({.doing = "check", .unit = "sheets", .count = names.size(), .at_once = 2});
//     runner.run([&](std::size_t job, std::size_t thread) { marks[job] = mark_of(names[job], checkers[thread]); });

#include <atomic>
#include <cstddef>
#include <functional>
#include <string>

namespace rastertrace {

/// How many jobs there are, and what the line of progress calls them.
struct Jobs {
    std::string doing{};
    std::string unit{};
    std::size_t count = 0;
    std::size_t at_once = 1; ///< threads
    bool run_programs =
        false; ///< run_program is called: a signal to end waits until what runs is ended
};

class JobRunner {
public:
    explicit JobRunner(Jobs jobs);

    /// Calls `work(job, thread)` once for each job, from 0 on; threads are numbered from 0, too. After an exception no
    /// job is begun; that of the first job that threw one is thrown once all jobs that run have ended.
    void run(const std::function<void(std::size_t job, std::size_t thread)>& work);

    /// For `work`: from this job on, none is begun.
    void stop_before(std::size_t job);

private:
    Jobs jobs_;
    std::atomic<std::size_t> end_;
};

} // namespace rastertrace
