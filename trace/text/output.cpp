// SPDX-License-Identifier: MIT
#include "output.h"

#include "file_place.h"
#include "process_files.h"
#include "text.h"
#include "unfinished_list.h"

#include <fmt/core.h>

#include <fcntl.h>
#include <limits.h>
#include <sys/stat.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <cstdio>
#include <filesystem>
#include <system_error>
#include <vector>

namespace rastertrace {

namespace {

[[noreturn]] void fail(const std::string& name, std::string_view what, int error) {
    throw problem_of_system(name, what, error);
}

constexpr std::string_view not_created = "could not be created";
constexpr std::string_view not_written = "could not be written";
constexpr std::string_view not_named = "could not be given its name";

void write_all(int descriptor, std::string_view bytes, const std::string& name) {
    while (!bytes.empty()) {
        const ssize_t count = ::write(descriptor, bytes.data(), bytes.size());
        if (count >= 0) {
            add_bytes_done({.written = static_cast<std::uint64_t>(count)});
            bytes.remove_prefix(static_cast<std::size_t>(count));
        } else if (errno == EAGAIN)
            wait_until_writable(descriptor);
        else if (errno != EINTR)
            fail(name, not_written, errno);
    }
}

FileId id_of(const struct stat& status) {
    return {.device = status.st_dev, .inode = status.st_ino};
}

/// A name in an open folder.
struct FilePlace {
    Descriptor folder;
    std::string name;
};

/// Where the symbolic link at a place leads to; nullopt if there is none.
std::optional<std::string> link_at(const FilePlace& place) {
    std::array<char, PATH_MAX> text;
    const ssize_t length =
        ::readlinkat(place.folder.number(), place.name.c_str(), text.data(), text.size());
    if (length < 0)
        return std::nullopt;
    return std::string(text.data(), static_cast<std::size_t>(length));
}

/// The place that a path names, symbolic links followed, even if there is no file yet. Working in an
/// open folder, nothing depends on the length of the path.
FilePlace place_of(const std::string& path) {
    FilePlace place;
    std::string rest = path.find('/') == std::string::npos ? "./" + path : path;
    // As many links as the system follows.
    for (int links = 0; links < 40; ++links) {
        const std::size_t name_begin = rest.find_last_of('/') + 1;
        if (name_begin > 0) {
            const std::string folder = rest.substr(0, name_begin);
            const int from = place.folder.is_open() ? place.folder.number() : AT_FDCWD;
            place.folder =
                Descriptor(::openat(from, folder.c_str(), O_PATH | O_DIRECTORY | O_CLOEXEC));
            if (!place.folder.is_open())
                fail(path, not_created, errno);
        }
        place.name = rest.substr(name_begin);
        auto link = link_at(place);
        if (!link)
            return place;
        rest = std::move(*link);
    }
    fail(path, not_created, ELOOP);
}

/// Calls `make(name)`, which returns false with errno set if it fails, with names that a file may
/// have for a while, until one is free. Returns the name, which is on the list of unfinished files
/// then; "" if it failed for another reason. The names are short: they fit where the final name does.
template <typename Make>
std::string make_under_temporary_name(const Descriptor& folder, Make&& make) {
    for (int attempt = 0; attempt < 100; ++attempt) {
        std::string name = fmt::format("rastertrace-{}-{}.part", ::getpid(), attempt);
        note_unfinished(folder.number(), name);
        if (make(name.c_str()))
            return name;
        const int error = errno;
        forget_unfinished(folder.number(), name);
        errno = error;
        if (error != EEXIST)
            break;
    }
    return "";
}

/// A file without a name in a folder; closed where the system has no such thing, or no way to give it
/// a name later.
Descriptor open_unnamed(const Descriptor& folder, mode_t mode) {
    Descriptor file(::openat(folder.number(), ".", O_TMPFILE | O_WRONLY | O_CLOEXEC, mode));
    if (file.is_open() && ::access(path_of_open(file).c_str(), F_OK) != 0)
        file.close();
    return file;
}

/// Where a file is written that would be at a path: its folder is made if it is there, and links are followed.
std::string place_below(const std::string& folder, const std::string& path) {
    namespace fs = std::filesystem;
    std::error_code error;
    std::error_code missing; // it may have been made below the other one
    const fs::path place = fs::weakly_canonical(fs::absolute(path, error), error);
    if (fs::is_directory(place.parent_path(), missing))
        fs::create_directories(folder + place.parent_path().string(), error);
    if (error)
        fail(path, not_created, error.value());
    return folder + place.string();
}

/// Gives an unnamed file a name that no other has; false, with errno set, if it cannot.
bool give_name(const Descriptor& file, const Descriptor& folder, const char* name) {
    return ::linkat(AT_FDCWD, path_of_open(file).c_str(), folder.number(), name,
                    AT_SYMLINK_FOLLOW) == 0;
}

} // namespace

void DescriptorOutput::write(std::string_view bytes) {
    write_all(descriptor_, bytes, name_);
}

FileOutput::FileOutput(const std::string& path) : path_(path) {
    struct stat status {};
    const bool exists = ::stat(path_.c_str(), &status) == 0;
    if (!exists && errno != ENOENT)
        fail(path_, not_created, errno);
    if (exists && S_ISDIR(status.st_mode))
        throw problem_of(path_, "expected a file to write, found a folder");
    const std::string elsewhere = folder_of_outputs();
    if (exists && !S_ISREG(status.st_mode) && elsewhere.empty()) {
        file_ = Descriptor(::open(path_.c_str(), O_WRONLY | O_NOCTTY | O_CLOEXEC));
        if (!file_.is_open())
            fail(path_, not_created, errno);
        return;
    }

    std::optional<unsigned> mode;
    if (exists) {
        older_ = id_of(status);
        mode = status.st_mode & 07777u;
        refuse_opened(*older_, path_);
    }
    FilePlace place = place_of(elsewhere.empty() ? path_ : place_below(elsewhere, path_));
    name_ = std::move(place.name);
    folder_ = std::move(place.folder);
    // An older file that may not be written is not replaced either.
    if (exists && elsewhere.empty() && ::access(path_.c_str(), W_OK) != 0)
        fail(path_, not_written, errno);
    if (::fstat(folder_.number(), &status) != 0)
        fail(path_, not_created, errno);
    folder_id_ = id_of(status);
    open_beside_target(mode);
}

void FileOutput::open_beside_target(std::optional<unsigned> mode) {
    // Until it has the mode of the older file, a file is its owner's alone.
    const mode_t first_mode = mode ? 0600 : 0666;
    file_ = open_unnamed(folder_, first_mode);
    if (!file_.is_open()) {
        const SignalsHeldBack held;
        temporary_ = make_under_temporary_name(folder_, [&](const char* name) {
            file_ = Descriptor(::openat(folder_.number(), name,
                                        O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, first_mode));
            return file_.is_open();
        });
    }
    if (!file_.is_open() && mode)
        fail(path_, "may be written, but its folder takes no new file to replace it by", errno);
    if (!file_.is_open())
        fail(path_, not_created, errno);
    if (mode && ::fchmod(file_.number(), *mode) != 0) {
        const int error = errno;
        remove_unfinished(folder_.number(), temporary_);
        fail(path_, not_written, error);
    }
}

FileOutput::~FileOutput() {
    remove_unfinished(folder_.number(), temporary_);
}

std::string FileOutput::identity() const {
    if (older_)
        return fmt::format("{}:{}", older_->device, older_->inode);
    return folder_.is_open() ? fmt::format("{}:{}:{}", folder_id_.device, folder_id_.inode, name_)
                             : std::string();
}

void FileOutput::write(std::string_view bytes) {
    write_all(file_.number(), bytes, path_);
}

void FileOutput::commit() {
    sync();
    take_name();
}

void FileOutput::sync() {
    // A device or a pipe says all that it says when it is closed. Of a file, this complains of what closing it could,
    // while the older file is still there.
    if (folder_.is_open() ? ::fsync(file_.number()) != 0 : !file_.close())
        fail(path_, not_written, errno);
}

void FileOutput::take_name() {
    if (!folder_.is_open())
        return;
    if (older_)
        refuse_opened(*older_, path_);

    // An unnamed file takes its name at once, or, where an older one has it, another one first. In
    // that moment only SIGKILL can leave a file behind.
    const SignalsHeldBack held;
    if (temporary_.empty() && !older_ && give_name(file_, folder_, name_.c_str()))
        return;
    if (temporary_.empty())
        temporary_ = make_under_temporary_name(
            folder_, [this](const char* name) { return give_name(file_, folder_, name); });
    if (temporary_.empty() ||
        ::renameat(folder_.number(), temporary_.c_str(), folder_.number(), name_.c_str()) != 0)
        fail(path_, not_named, errno);
    forget_unfinished(folder_.number(), temporary_);
    temporary_.clear();
}

void write_file(const std::string& path, std::string_view bytes) {
    FileOutput file(path);
    file.write(bytes);
    file.commit();
}

void make_folder(const std::string& path) {
    namespace fs = std::filesystem;
    std::error_code error;
    const fs::path place = fs::weakly_canonical(fs::absolute(path, error), error);
    const std::string from_here =
        (place.lexically_relative(fs::canonical(".", error)) / "").string();
    if (runs_for_page() && !fs::exists(place, error) && from_here.starts_with("../"))
        throw problem_of(path,
                         "expected a folder below the one that the commands of the page run in, "
                         "found one outside");
    fs::create_directories(
        folder_of_outputs().empty() ? path : folder_of_outputs() + place.string(), error);
    if (error)
        fail(path, "the folder could not be made", error.value());
}

FileOutput& FileOutputs::open(const std::string& path) {
    FileOutput& file = files_.emplace_back(path);
    const std::string identity = file.identity();
    const auto [first, is_new] = paths_.try_emplace(identity, path);
    if (!is_new && !identity.empty())
        throw problem_of(path,
                         fmt::format("expected files to write that differ, found the file {} again",
                                     first->second));
    return file;
}

void FileOutputs::commit() {
    for (FileOutput& file : files_)
        file.sync();
    const SignalsHeldBack held;
    std::vector<std::string> done;
    for (FileOutput& file : files_)
        try {
            file.take_name();
            if (file.folder_.is_open())
                done.push_back(file.path_);
        } catch (Problem& problem) {
            if (files_.size() > 1)
                problem.hint = done.empty() ? "none of the other files is new"
                                            : "new by then: " + joined(done, ", ");
            throw;
        }
}

} // namespace rastertrace
