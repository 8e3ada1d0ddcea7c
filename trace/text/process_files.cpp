// SPDX-License-Identifier: MIT
#include "process_files.h"

#include "file_place.h"
#include "output.h"
#include "problem.h"

#include <fmt/core.h>

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <atomic>
#include <fstream>
#include <mutex>
#include <optional>
#include <utility>
#include <vector>

namespace rastertrace {

namespace {

// Rules are for a process as a whole, and so is what it has opened: no caller can forget to hand them on.
struct OpenedFile {
    FileId file;
    std::string path{}; ///< that has led to it; "" if another run has opened it
};
std::vector<OpenedFile> opened;
std::mutex opened_mutex; // several threads may open files
Descriptor shared_list;
std::string output_folder;
std::atomic<std::uint64_t> bytes_read = 0;
std::atomic<std::uint64_t> bytes_written = 0;

void add_to_shared_list(char what, const FileId& file) {
    if (shared_list.is_open())
        DescriptorOutput(shared_list.number(), "a temporary file")
            .write(fmt::format("{} {} {}\n", what, file.device, file.inode));
}

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
    if (std::any_of(opened.begin(), opened.end(), is_it))
        return;
    opened.push_back({file, path});
    add_to_shared_list('r', file);
}

void note_written(const FileId& file) {
    add_to_shared_list('w', file);
}

void refuse_opened(const FileId& file, const std::string& name) {
    const std::scoped_lock lock(opened_mutex);
    for (const OpenedFile& one : opened)
        // The number of a file that is gone may be another one's now.
        if (one.file == file && (one.path.empty() || file_at(one.path) == file))
            throw problem_of(name, "expected another file than those that are read, found one of "
                                   "them");
}

ReadToReplace::ReadToReplace() {
    const std::scoped_lock lock(opened_mutex);
    before_ = opened.size();
}

ReadToReplace::~ReadToReplace() {
    const std::scoped_lock lock(opened_mutex);
    opened.resize(std::min(opened.size(), before_));
}

void share_opened_files(const std::string& path) {
    std::ifstream list(path);
    std::vector<FileId> written;
    char what = 0;
    for (OpenedFile one; list >> what >> one.file.device >> one.file.inode;)
        if (what == 'r')
            opened.push_back(one);
        else
            written.push_back(one.file);
    std::erase_if(opened, [&written](const OpenedFile& one) {
        return std::find(written.begin(), written.end(), one.file) != written.end();
    });
    shared_list = Descriptor(::open(path.c_str(), O_WRONLY | O_CREAT | O_APPEND | O_CLOEXEC, 0600));
}

bool shares_opened_files() {
    return shared_list.is_open();
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

std::string path_of_open(const Descriptor& file) {
    return fmt::format("/proc/self/fd/{}", file.number());
}

} // namespace rastertrace
