// SPDX-License-Identifier: MIT
#include "process_files.h"

#include "file_place.h"
#include "problem.h"

#include <fmt/core.h>

#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <atomic>
#include <filesystem>
#include <mutex>
#include <optional>
#include <system_error>
#include <utility>
#include <vector>

namespace rastertrace {

namespace {

// Rules are for a process as a whole, and so is what it has opened: no caller can forget to hand them on.
struct OpenedFile {
    FileId file;
    std::string path; ///< that has led to it
};
std::vector<OpenedFile> opened;
std::vector<OpenedFile> opened_before; // a ReadToReplace
std::mutex opened_mutex;               // several threads may open files
std::optional<std::string> page_outputs;
std::atomic<std::uint64_t> bytes_read = 0;
std::atomic<std::uint64_t> bytes_written = 0;

/// Which file a path leads to; nullopt if that is no regular file.
std::optional<FileId> file_at(const std::string& path) {
    struct stat status {};
    if (::stat(path.c_str(), &status) != 0 || !S_ISREG(status.st_mode))
        return std::nullopt;
    return FileId{.device = status.st_dev, .inode = status.st_ino};
}

} // namespace

void note_opened(const FileId& file, const std::string& path) {
    const std::scoped_lock lock(opened_mutex);
    const auto is_it = [&file](const OpenedFile& one) { return one.file == file; };
    const auto known = std::find_if(opened.begin(), opened.end(), is_it);
    OpenedFile& it = known == opened.end() ? opened.emplace_back() : *known;
    std::error_code error;
    it = {file, std::filesystem::absolute(path, error)}; // the current folder may change
}

void refuse_opened(const FileId& file, const std::string& name) {
    const std::scoped_lock lock(opened_mutex);
    for (const OpenedFile& one : opened)
        // The number of a file that is gone may be another one's now.
        if (one.file == file && file_at(one.path) == file)
            throw problem_of(name, "expected another file than those that are read, found one of "
                                   "them");
}

ReadToReplace::ReadToReplace() {
    const std::scoped_lock lock(opened_mutex);
    opened_before = opened;
}

ReadToReplace::~ReadToReplace() {
    const std::scoped_lock lock(opened_mutex);
    opened = std::move(opened_before);
}

BytesDone bytes_done() {
    return {.read = bytes_read, .written = bytes_written};
}

void add_bytes_done(const BytesDone& more) {
    bytes_read += more.read;
    bytes_written += more.written;
}

void run_for_page(std::string folder, std::span<const std::string> pages) {
    page_outputs = std::move(folder);
    for (const std::string& page : pages)
        if (const auto file = file_at(page))
            note_opened(*file, page);
}

bool runs_for_page() {
    return page_outputs.has_value();
}

std::string folder_of_outputs() {
    return page_outputs.value_or("");
}

std::string path_of_open(const Descriptor& file) {
    return fmt::format("/proc/self/fd/{}", file.number());
}

} // namespace rastertrace
