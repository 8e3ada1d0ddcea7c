// SPDX-License-Identifier: MIT
#include "process_files.h"

#include "file_place.h"
#include "input_file.h"
#include "output.h"
#include "problem.h"
#include "text.h"

#include <fmt/core.h>

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <atomic>
#include <cinttypes>
#include <cstdio>
#include <filesystem>
#include <mutex>
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
std::mutex opened_mutex; // several threads may open files
Descriptor shared_list;
std::string output_folder;
std::atomic<std::uint64_t> bytes_read = 0;
std::atomic<std::uint64_t> bytes_written = 0;

/// A line of the shared list, which no other run writes into.
void add_to_shared_list(char what, const FileId& file, const std::string& path) {
    if (!shared_list.is_open())
        return;
    const std::string place = std::filesystem::absolute(path).string();
    const std::string line = fmt::format("{} {} {} {}", what, file.device, file.inode, place);
    DescriptorOutput(shared_list.number(), "a temporary file").write(line + '\0');
}

} // namespace

std::optional<FileId> file_at(const std::string& path) {
    struct stat status {};
    if (::stat(path.c_str(), &status) != 0 || !S_ISREG(status.st_mode))
        return std::nullopt;
    return FileId{.device = status.st_dev, .inode = status.st_ino};
}

void note_opened(const FileId& file, const std::string& path) {
    const std::scoped_lock lock(opened_mutex);
    const auto is_it = [&file](const OpenedFile& one) { return one.file == file; };
    if (std::any_of(opened.begin(), opened.end(), is_it))
        return;
    opened.push_back({file, path});
    add_to_shared_list('r', file, path);
}

void note_written(const FileId& file) {
    add_to_shared_list('w', file, "/");
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
    before_ = opened.size();
}

ReadToReplace::~ReadToReplace() {
    const std::scoped_lock lock(opened_mutex);
    opened.resize(std::min(opened.size(), before_));
}

void share_opened_files(const std::string& path) {
    InputFile list(path,
                   Descriptor(::open(path.c_str(), O_RDWR | O_CREAT | O_APPEND | O_CLOEXEC, 0600)));
    std::string text;
    while (list.read_into(text)) {
    }
    std::vector<FileId> written;
    for (const std::string& line : split_at(text, '\0')) {
        char what = 0;
        FileId file;
        int length = 0; // of what stands before the path
        std::sscanf(line.c_str(), "%c %" SCNu64 " %" SCNu64 " %n", &what, &file.device, &file.inode,
                    &length);
        if (what == 'r')
            opened.push_back({file, line.substr(static_cast<std::size_t>(length))});
        else
            written.push_back(file);
    }
    std::erase_if(opened, [&written](const OpenedFile& one) {
        return std::find(written.begin(), written.end(), one.file) != written.end();
    });
    shared_list = Descriptor(::open(path.c_str(), O_WRONLY | O_APPEND | O_CLOEXEC));
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
