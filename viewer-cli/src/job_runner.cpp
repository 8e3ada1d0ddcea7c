// SPDX-License-Identifier: MIT
#include "job_runner.h"

#include "progress.h"
#include "run_program.h"

#include <rastertrace/trace/text/in_threads.h>

#include <cstdint>
#include <exception>
#include <mutex>
#include <optional>
#include <utility>

namespace rastertrace {

JobRunner::JobRunner(Jobs jobs) : jobs_(std::move(jobs)), end_(jobs_.count) {}

void JobRunner::run(const std::function<void(std::size_t job, std::size_t thread)>& work) {
    std::atomic<std::uint64_t> done = 0;
    std::mutex mutex;
    std::optional<std::size_t> failed;
    std::exception_ptr failure;

    // Signals come again while progress is still known: they tell it.
    const Progress progress(
        {.doing = jobs_.doing, .unit = jobs_.unit, .total = jobs_.count, .done = [&done] {
             return done.load();
         }});
    std::optional<EndingHeldBack> ending;
    if (jobs_.run_programs)
        ending.emplace();
    in_threads(end_, jobs_.at_once, [&](std::size_t job, std::size_t thread) {
        try {
            work(job, thread);
            ++done;
        } catch (...) {
            const std::scoped_lock lock(mutex);
            if (!failed || job < *failed) {
                failed = job;
                failure = std::current_exception();
            }
            stop_before(0);
        }
    });
    if (failure)
        std::rethrow_exception(failure);
}

void JobRunner::stop_before(std::size_t job) {
    std::size_t end = end_;
    while (job < end && !end_.compare_exchange_weak(end, job)) {
    }
}

} // namespace rastertrace
