// SPDX-License-Identifier: MIT
#include "input_file.h"

#include "file_place.h"

#include <fmt/core.h>

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <system_error>
#include <utility>

namespace rastertrace {

namespace {

Problem unreadable(const std::string& name, int error) {
    return problem_of_system(name, "could not be read", error);
}

} // namespace

Result<InputFile> InputFile::open(const std::string& path, Kind kind) {
    const bool must_be_regular = kind == Kind::regular_file;
    const bool is_standard_input = path == "-" && !must_be_regular;
    const std::string name = is_standard_input ? "standard input" : path;

    // A file that is not there was asked for wrongly; one that cannot be read on is broken.
    Descriptor opened;
    if (!is_standard_input)
        opened = Descriptor(
            ::open(path.c_str(), O_RDONLY | O_CLOEXEC | (must_be_regular ? O_NONBLOCK : 0)));
    if (!is_standard_input && !opened.is_open()) {
        Problem problem =
            problem_of(name, fmt::format("expected a file that can be read, found: {}",
                                         std::generic_category().message(errno)));
        problem.cause = cause_of_open_error(errno);
        return problem;
    }
    const int descriptor = is_standard_input ? STDIN_FILENO : opened.number();
    InputFile file(name, std::move(opened), descriptor);
    struct stat status {};
    if (::fstat(descriptor, &status) != 0)
        return unreadable(name, errno);
    if (S_ISDIR(status.st_mode))
        return problem_of(name, "expected a file, found a folder");
    if (must_be_regular && !S_ISREG(status.st_mode))
        return problem_of(name, "expected a file, found a pipe or a device");
    if (S_ISREG(status.st_mode)) {
        file.id_ = FileId{.device = status.st_dev, .inode = status.st_ino};
        file.told_size_ = static_cast<std::size_t>(std::max<off_t>(status.st_size, 0));
        note_opened(*file.id_, is_standard_input ? "/proc/self/fd/0" : path);
    }
    return file;
}

bool InputFile::read_into(std::string& text) {
    // Neither the size that the system tells nor the end of the file is trusted.
    std::array<char, 1 << 16> buffer;
    for (;;) {
        const ssize_t count = ::read(descriptor_, buffer.data(), buffer.size());
        if (count >= 0) {
            text.append(buffer.data(), static_cast<std::size_t>(count));
            return count > 0;
        }
        if (errno == EAGAIN)
            wait_until_readable(descriptor_);
        else if (errno != EINTR)
            throw unreadable(name_, errno);
    }
}

} // namespace rastertrace
