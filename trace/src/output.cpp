// SPDX-License-Identifier: MIT
#include <rastertrace/trace/output.h>

#include <fmt/format.h>

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <cstdio>
#include <cstdlib>
#include <memory>
#include <system_error>

namespace rastertrace {

namespace {

[[noreturn]] void fail(const std::string& name, std::string_view what, int error) {
    Problem problem =
        problem_of(name, fmt::format("{}: {}", what, std::generic_category().message(error)));
    problem.cause = Problem::Cause::system;
    throw problem;
}

void write_all(int descriptor, std::string_view bytes, const std::string& name) {
    while (!bytes.empty()) {
        const ssize_t count = ::write(descriptor, bytes.data(), bytes.size());
        if (count >= 0)
            bytes.remove_prefix(static_cast<std::size_t>(count));
        else if (errno != EINTR)
            fail(name, "could not be written", errno);
    }
}

/// The path with all symbolic links followed, or as it is if there is no such file yet.
std::string resolved(const std::string& path) {
    const std::unique_ptr<char, decltype(&std::free)> real(::realpath(path.c_str(), nullptr),
                                                           &std::free);
    return real ? std::string(real.get()) : path;
}

} // namespace

void DescriptorOutput::write(std::string_view bytes) {
    write_all(descriptor_, bytes, name_);
}

FileOutput::FileOutput(const std::string& path) : path_(path), target_(resolved(path)) {
    struct stat status {};
    const bool exists = ::stat(target_.c_str(), &status) == 0;
    if (exists && S_ISDIR(status.st_mode))
        throw problem_of(path_, "expected a file to write, found a folder");

    if (exists && !S_ISREG(status.st_mode)) {
        descriptor_ = ::open(target_.c_str(), O_WRONLY | O_CLOEXEC);
    } else {
        // An older file that may not be written is not replaced either.
        if (exists && ::access(target_.c_str(), W_OK) != 0)
            fail(path_, "could not be written", errno);
        const mode_t mode = exists ? status.st_mode & 07777 : 0666;
        for (int attempt = 0; descriptor_ < 0 && attempt < 100; ++attempt) {
            temporary_ = fmt::format("{}.{}.{}.part", target_, ::getpid(), attempt);
            descriptor_ = ::open(temporary_.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, mode);
            if (descriptor_ < 0 && errno != EEXIST)
                break;
        }
    }
    if (descriptor_ < 0) {
        temporary_.clear();
        fail(path_, "could not be created", errno);
    }
}

FileOutput::~FileOutput() {
    if (descriptor_ >= 0)
        ::close(descriptor_);
    if (!temporary_.empty())
        ::unlink(temporary_.c_str());
}

void FileOutput::write(std::string_view bytes) {
    write_all(descriptor_, bytes, path_);
}

void FileOutput::commit() {
    const int descriptor = std::exchange(descriptor_, -1);
    if (::close(descriptor) != 0)
        fail(path_, "could not be written", errno);
    if (temporary_.empty())
        return;
    if (std::rename(temporary_.c_str(), target_.c_str()) != 0)
        fail(path_, "could not be given its name", errno);
    temporary_.clear();
}

} // namespace rastertrace
