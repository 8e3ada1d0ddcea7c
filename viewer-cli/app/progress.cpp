// SPDX-License-Identifier: MIT
#include "app/progress.h"

#include <rastertrace/trace/text/process_files.h>
#include <rastertrace/trace/text/text.h>

#include <fmt/core.h>

#include <sys/ioctl.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <atomic>
#include <chrono>
#include <cmath>
#include <condition_variable>
#include <csignal>
#include <cstring>
#include <filesystem>
#include <string_view>
#include <system_error>
#include <utility>

namespace rastertrace {

namespace {

using Seconds = std::chrono::duration<double>;
using Text = std::array<char, 200>;

/// What a signal handler prints: one is read while the other is written. Nothing is shown while it is nullptr.
std::array<Text, 2> last_words;
std::atomic<const Text*> words_shown = nullptr;

/// 1, 1.2, 12, 120.
std::string amount(double value) {
    return value < 9.95 && value != std::floor(value) ? fmt::format("{:.1f}", value)
                                                      : fmt::format("{:.0f}", value);
}

std::string time_text(double seconds) {
    constexpr double minute = 60;
    return seconds < 2 * minute ? fmt::format("{:.0f} s", seconds)
                                : fmt::format("{:.0f} min", seconds / minute);
}

/// Writes at once, also from a signal handler. What cannot be written is of no importance.
void write_error(std::string_view text) noexcept {
    [[maybe_unused]] const auto written = ::write(STDERR_FILENO, text.data(), text.size());
}

std::size_t columns_of_error() {
    constexpr std::size_t usual = 80;
    struct winsize window {};
    return ::ioctl(STDERR_FILENO, TIOCGWINSZ, &window) == 0 && window.ws_col > 1 ? window.ws_col
                                                                                 : usual;
}

/// "fuzz: 120 of 1000 scenes"
std::string amount_text(const LongWork& work, std::uint64_t done) {
    const auto in_units = [&](std::uint64_t count) {
        return amount(static_cast<double>(count) / static_cast<double>(work.one_unit));
    };
    return fmt::format("{}: {}{} {}", work.doing, in_units(done),
                       work.total == 0 ? "" : " of " + in_units(work.total), work.unit);
}

} // namespace

LongWork reading_of(std::string doing, const std::vector<std::string>& paths) {
    std::uint64_t total = 0;
    for (const std::string& path : paths)
        if (std::error_code error; std::filesystem::is_regular_file(path, error))
            total += std::filesystem::file_size(path, error);
    if (total < bytes_in_a_megabyte)
        return {.doing = "drawing a scene"}; // a scene, or what is read in no time
    return {.doing = std::move(doing),
            .unit = "MB",
            .total = total,
            .done = [total] { return std::min(bytes_done().read, total); },
            .one_unit = bytes_in_a_megabyte};
}

std::string progress_line(const LongWork& work, std::uint64_t done, double seconds) {
    if (!work.done)
        return work.doing;
    const double rate = static_cast<double>(done) / seconds;
    std::string line = fmt::format("{}, {} a second", amount_text(work, done),
                                   amount(rate / static_cast<double>(work.one_unit)));
    if (done > 0 && done < work.total)
        line += fmt::format(", {} left", time_text(static_cast<double>(work.total - done) / rate));
    return line;
}

Progress::Progress(LongWork work) : work_(std::move(work)) {
    if (::isatty(STDERR_FILENO) == 0)
        return;
    // No signal comes to the thread: files are guarded against signals in the threads that write them (output.h).
    sigset_t all;
    sigset_t before;
    ::sigfillset(&all);
    ::pthread_sigmask(SIG_SETMASK, &all, &before);
    try {
        thread_ = std::jthread([this](const std::stop_token& stopped) { show_until(stopped); });
    } catch (const std::system_error&) {
        // The work goes on, and nobody sees how far it is.
    }
    ::pthread_sigmask(SIG_SETMASK, &before, nullptr);
}

Progress::~Progress() {
    if (!thread_.joinable())
        return;
    thread_.request_stop();
    thread_.join();
    clear_progress_line();
    words_shown = nullptr;
}

void Progress::say(std::string doing) {
    const std::scoped_lock lock(mutex_);
    work_.doing = std::move(doing);
}

void Progress::show_until(const std::stop_token& stopped) const {
    using namespace std::chrono_literals;
    const auto begin = std::chrono::steady_clock::now();
    std::condition_variable_any ticks; // by time alone
    std::mutex unused;
    std::unique_lock waiting(unused);
    for (std::size_t turn = 0;; ++turn) {
        ticks.wait_for(waiting, stopped, turn == 0 ? 1000ms : 200ms, [] { return false; });
        if (stopped.stop_requested())
            return;
        const std::scoped_lock lock(mutex_);
        const std::uint64_t done = work_.done ? work_.done() : 0;
        const Seconds seconds = std::chrono::steady_clock::now() - begin;
        write_error("\r\x1b[K" +
                    shortened(progress_line(work_, done, seconds.count()), columns_of_error() - 1));
        Text& words = last_words[turn % last_words.size()];
        const std::string ended =
            work_.done ? fmt::format("\ninterrupted: {}; unfinished files are removed\n",
                                     amount_text(work_, done))
                       : fmt::format("\ninterrupted while {}\n", work_.doing);
        const std::size_t length = std::min(ended.size(), words.size() - 1);
        std::copy_n(ended.begin(), length, words.begin());
        words[length] = '\0';
        words_shown = &words;
    }
}

void clear_progress_line() noexcept {
    if (words_shown.load() != nullptr)
        write_error("\r\x1b[K");
}

void tell_interrupted_work() noexcept {
    if (const Text* const words = words_shown.exchange(nullptr))
        write_error({words->data(), ::strnlen(words->data(), words->size())});
}

} // namespace rastertrace
