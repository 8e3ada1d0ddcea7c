// SPDX-License-Identifier: MIT
#include "frames/frame_files.h"

#include <fmt/core.h>

#include <sys/resource.h>

#include <filesystem>
#include <system_error>
#include <utility>

namespace rastertrace {

namespace {

/// Lets the program have this many files open, or says that it cannot.
void allow_open_files(std::size_t frames) {
    constexpr rlim_t of_frame = 2; // the file and its folder
    constexpr rlim_t of_others = 32;
    const rlim_t needed = of_frame * frames + of_others;
    rlimit limit{};
    if (::getrlimit(RLIMIT_NOFILE, &limit) != 0 || needed <= limit.rlim_cur)
        return;
    if (needed > limit.rlim_max)
        throw problem_of("",
                         fmt::format("expected at most {} frames to write at once, found {}",
                                     (limit.rlim_max - of_others) / of_frame, frames),
                         "--frame 1 writes the first; `ulimit -H -n` tells how many files may be "
                         "open");
    limit.rlim_cur = needed;
    ::setrlimit(RLIMIT_NOFILE, &limit);
}

} // namespace

std::string path_of_frame(const std::string& path, std::size_t frame, std::size_t digits) {
    const std::filesystem::path whole(path);
    return (whole.parent_path() / fmt::format("{}-{:0{}}{}", whole.stem().string(), frame, digits,
                                              whole.extension().string()))
        .string();
}

FrameFiles::FrameFiles(std::string path, std::size_t count)
    : path_(std::move(path)), count_(count) {
    std::error_code error;
    if (std::filesystem::exists(path_, error) && !std::filesystem::is_regular_file(path_, error))
        throw problem_of(
            path_, fmt::format("expected a name for {} files, found a device or a folder", count_));
    allow_open_files(count_);
}

FileOutput& FrameFiles::open(std::size_t frame) {
    return files_.open(path_of_frame(path_, frame, std::to_string(count_).size()));
}

} // namespace rastertrace
