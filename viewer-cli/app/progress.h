// SPDX-License-Identifier: MIT
#pragma once

// How far long work has come, on a terminal: one line of standard error, after the first second, cleared in the end.
//
//     std::atomic<std::uint64_t> done = 0;
//     const Progress progress({.doing = "fuzz", .unit = "scenes", .total = 1000, .done = [&] { return done.load(); }});
//     // fuzz: 120 of 1000 scenes, 34 a second, 26 s left

#include <cstdint>
#include <functional>
#include <mutex>
#include <string>
#include <thread>
#include <vector>

namespace rastertrace {

/// What a line of progress is made of.
struct LongWork {
    std::string doing{};
    std::string unit{};
    std::uint64_t total = 0; ///< 0 if nobody knows
    std::function<std::uint64_t()> done{};
    std::uint64_t one_unit = 1; ///< how many of `done` are one `unit`
};

inline constexpr std::uint64_t bytes_in_a_megabyte = 1'000'000;

/// The progress of reading these files once.
LongWork reading_of(std::string doing, const std::vector<std::string>& paths);

/// The line after so many seconds.
std::string progress_line(const LongWork& work, std::uint64_t done, double seconds);

class Progress {
public:
    /// `work.done` is called by another thread. Nothing is shown where standard error is no terminal.
    explicit Progress(LongWork work);
    Progress(const Progress&) = delete;
    Progress& operator=(const Progress&) = delete;
    ~Progress();

    /// Says what is being done from now on.
    void say(std::string doing);

private:
    void show_until(const std::stop_token& stopped) const;

    LongWork work_;
    mutable std::mutex mutex_; ///< of work_.doing
    std::jthread thread_;
};

/// Clears the line of progress, if one is shown: a message is to stand in its place.
void clear_progress_line() noexcept;

/// For signal handlers: prints what had been done, if a line of progress is shown.
void tell_interrupted_work() noexcept;

} // namespace rastertrace
