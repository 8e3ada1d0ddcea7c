// SPDX-License-Identifier: MIT
#pragma once

// An open file, and which file it is.

#include <cstdint>
#include <utility>

namespace rastertrace {

/// Which file it is, whatever name leads to it: two names of one file, by a symbolic or a hard link,
/// have the same.
struct FileId {
    std::uint64_t device = 0;
    std::uint64_t inode = 0;

    bool operator==(const FileId&) const = default;
};

/// A file descriptor that is closed in the end.
class Descriptor {
public:
    /// Takes what open() returned, which is negative if it failed.
    explicit Descriptor(int number = -1) : number_(number) {}
    Descriptor(Descriptor&& other) noexcept : number_(std::exchange(other.number_, -1)) {}
    Descriptor& operator=(Descriptor other) noexcept {
        std::swap(number_, other.number_);
        return *this;
    }
    ~Descriptor() { close(); }

    bool is_open() const { return number_ >= 0; }
    int number() const { return number_; }

    /// False, with errno set, if the system complains; the descriptor is closed all the same.
    bool close();

private:
    int number_;
};

/// Waits until a descriptor that does not wait by itself can be read or written again. To be called
/// where errno is EAGAIN.
void wait_until_readable(int descriptor);
void wait_until_writable(int descriptor);

} // namespace rastertrace
