// SPDX-License-Identifier: MIT
#include "process_files.h"

#include "file_place.h"

#include <fmt/core.h>

#include <limits.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <atomic>
#include <mutex>
#include <utility>

namespace rastertrace {

namespace {

// Rules are for a process as a whole, and so is what it has opened: no caller can forget to hand them on.
std::vector<FileId> opened;
std::mutex opened_mutex; // several threads may open files
std::string output_folder;
std::atomic<std::uint64_t> bytes_read = 0;
std::atomic<std::uint64_t> bytes_written = 0;

} // namespace

const std::vector<FileId>& opened_files() {
    return opened;
}

BytesDone bytes_done() {
    return {.read = bytes_read, .written = bytes_written};
}

void add_bytes_done(const BytesDone& more) {
    bytes_read += more.read;
    bytes_written += more.written;
}

void write_files_below(std::string folder) {
    output_folder = std::move(folder);
}

const std::string& folder_of_outputs() {
    return output_folder;
}

void note_opened(const FileId& file) {
    const std::scoped_lock lock(opened_mutex);
    if (std::find(opened.begin(), opened.end(), file) == opened.end())
        opened.push_back(file);
}

std::string path_of_open(const Descriptor& file) {
    return fmt::format("/proc/self/fd/{}", file.number());
}

std::string place_of_open(const Descriptor& file) {
    std::array<char, PATH_MAX> place;
    const ssize_t length = ::readlink(path_of_open(file).c_str(), place.data(), place.size());
    return length < 0 ? std::string() : std::string(place.data(), static_cast<std::size_t>(length));
}

} // namespace rastertrace
