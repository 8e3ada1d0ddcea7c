// SPDX-License-Identifier: MIT
// A library to be loaded before all others (LD_PRELOAD): it makes calls into the system fail, as full
// disks, broken disks and lack of memory do. scripts/fail-nth-call.sh is its user.
//
//     FAIL_CALL=write        open, close, rename (linkat too), fsync, read, stat or malloc
//     FAIL_AT=3              the third call of that kind, from 1,
//     FAIL_ALWAYS=1          and all that follow
//     FAIL_ERRNO=5           with this error instead of the usual one
//     FAIL_MARK=file         is created when the first call fails
//     FAIL_TMPFILE=1         the file system knows no O_TMPFILE

#include <fcntl.h>
#include <sys/stat.h>
#include <sys/syscall.h>
#include <unistd.h>

#include <cerrno>
#include <cstdarg>
#include <cstddef>
#include <cstdlib>
#include <cstring>

// What malloc is made of in glibc, under a name that nothing replaces.
extern "C" void* __libc_malloc(std::size_t size);
extern "C" void* __libc_calloc(std::size_t count, std::size_t size);
extern "C" void* __libc_realloc(void* old, std::size_t size);

namespace {

struct Settings {
    const char* call = nullptr;
    long at = 0;
    bool always = false;
    int error = 0;
    const char* mark = nullptr;
    bool has_tmpfile = true;
};

Settings settings;
long calls = 0;

long number_from(const char* name) {
    const char* const text = std::getenv(name);
    return text == nullptr ? 0 : std::strtol(text, nullptr, 10);
}

/// What is called before, by the dynamic loader, does not count.
[[gnu::constructor]] void begin() {
    settings = {std::getenv("FAIL_CALL"),        number_from("FAIL_AT"),
                number_from("FAIL_ALWAYS") != 0, static_cast<int>(number_from("FAIL_ERRNO")),
                std::getenv("FAIL_MARK"),        number_from("FAIL_TMPFILE") == 0};
}

/// Counts a call; true, with errno set, if it is to fail.
bool fails(const char* call, int usual_error) {
    if (settings.call == nullptr || std::strcmp(settings.call, call) != 0)
        return false;
    ++calls;
    if (calls != settings.at && !(settings.always && calls > settings.at))
        return false;
    if (settings.mark != nullptr) {
        const long file =
            ::syscall(SYS_openat, AT_FDCWD, settings.mark, O_WRONLY | O_CREAT | O_CLOEXEC, 0666);
        if (file >= 0)
            ::syscall(SYS_close, file);
    }
    errno = settings.error != 0 ? settings.error : usual_error;
    return true;
}

int open_at(int folder, const char* path, int flags, mode_t mode) {
    if (!settings.has_tmpfile && (flags & O_TMPFILE) == O_TMPFILE) {
        errno = EOPNOTSUPP;
        return -1;
    }
    if (fails("open", EMFILE))
        return -1;
    return static_cast<int>(::syscall(SYS_openat, folder, path, flags, mode));
}

int stat_at(int folder, const char* path, struct stat* status, int flags) {
    if (fails("stat", EIO))
        return -1;
    return static_cast<int>(::syscall(SYS_newfstatat, folder, path, status, flags));
}

} // namespace

extern "C" {

ssize_t write(int file, const void* bytes, std::size_t count) {
    return fails("write", ENOSPC) ? -1 : ::syscall(SYS_write, file, bytes, count);
}

ssize_t read(int file, void* bytes, std::size_t count) {
    return fails("read", EIO) ? -1 : ::syscall(SYS_read, file, bytes, count);
}

int open(const char* path, int flags, ...) {
    va_list rest;
    va_start(rest, flags);
    const auto mode = static_cast<mode_t>(va_arg(rest, int));
    va_end(rest);
    return open_at(AT_FDCWD, path, flags, mode);
}

int openat(int folder, const char* path, int flags, ...) {
    va_list rest;
    va_start(rest, flags);
    const auto mode = static_cast<mode_t>(va_arg(rest, int));
    va_end(rest);
    return open_at(folder, path, flags, mode);
}

/// As Linux does it, the file is closed all the same.
int close(int file) {
    const auto result = static_cast<int>(::syscall(SYS_close, file));
    return fails("close", EIO) ? -1 : result;
}

int renameat(int from_folder, const char* from, int to_folder, const char* to) noexcept {
    return fails("rename", EIO)
               ? -1
               : static_cast<int>(::syscall(SYS_renameat2, from_folder, from, to_folder, to, 0));
}

int rename(const char* from, const char* to) noexcept {
    return renameat(AT_FDCWD, from, AT_FDCWD, to);
}

int linkat(int from_folder, const char* from, int to_folder, const char* to, int flags) noexcept {
    return fails("rename", EIO)
               ? -1
               : static_cast<int>(::syscall(SYS_linkat, from_folder, from, to_folder, to, flags));
}

int fsync(int file) {
    return fails("fsync", EIO) ? -1 : static_cast<int>(::syscall(SYS_fsync, file));
}

int stat(const char* path, struct stat* status) noexcept {
    return stat_at(AT_FDCWD, path, status, 0);
}

int lstat(const char* path, struct stat* status) noexcept {
    return stat_at(AT_FDCWD, path, status, AT_SYMLINK_NOFOLLOW);
}

int fstat(int file, struct stat* status) noexcept {
    return stat_at(file, "", status, AT_EMPTY_PATH);
}

int fstatat(int folder, const char* path, struct stat* status, int flags) noexcept {
    return stat_at(folder, path, status, flags);
}

void* malloc(std::size_t size) {
    return fails("malloc", ENOMEM) ? nullptr : __libc_malloc(size);
}

void* calloc(std::size_t count, std::size_t size) {
    return fails("malloc", ENOMEM) ? nullptr : __libc_calloc(count, size);
}

void* realloc(void* old, std::size_t size) {
    return fails("malloc", ENOMEM) ? nullptr : __libc_realloc(old, size);
}

} // extern "C"
