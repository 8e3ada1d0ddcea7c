// SPDX-License-Identifier: MIT
#include "process_files.h"

#include "file_place.h"
#include "problem.h"

#include <fmt/core.h>

#include <fcntl.h>
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
FileRules rules;
std::atomic<std::uint64_t> bytes_read = 0;
std::atomic<std::uint64_t> bytes_written = 0;

void refuse_outside(const std::string& place, const std::string& path) {
    const std::string folder = rules.below == "/" ? "" : rules.below;
    if (!rules.below.empty() && !place.starts_with(folder + "/"))
        throw problem_of(path,
                         "expected a file below the folder in which renew runs, found one outside",
                         "renew --allow-outside lets the commands of a page use any file");
}

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

void set_file_rules(FileRules new_rules) {
    rules = std::move(new_rules);
}

const FileRules& file_rules() {
    return rules;
}

void note_opened(const FileId& file) {
    const std::scoped_lock lock(opened_mutex);
    if (std::find(opened.begin(), opened.end(), file) == opened.end())
        opened.push_back(file);
}

Descriptor open_by_rules(const std::string& path, int flags) {
    if (rules.below.empty())
        return Descriptor(::open(path.c_str(), flags | O_CLOEXEC));
    // To open a pipe may wait, and a device may act: the place is looked at first, and that place is opened.
    const Descriptor place(::open(path.c_str(), O_PATH | O_CLOEXEC));
    if (!place.is_open())
        return Descriptor();
    refuse_outside(place_of_open(place), path);
    return Descriptor(::open(path_of_open(place).c_str(), flags | O_CLOEXEC));
}

void refuse_outside(const Descriptor& folder, const std::string& name, const std::string& path) {
    refuse_outside(place_of_open(folder) + "/" + name, path);
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
