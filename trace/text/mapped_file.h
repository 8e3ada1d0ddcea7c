// SPDX-License-Identifier: MIT
#pragma once

// The bytes of a file, looked at where they are: no memory is taken for them.
//
//     const auto bytes = MappedFile::of(descriptor, "trace.jsonl");  // throws a Problem

#include <cstddef>
#include <memory>
#include <string>
#include <string_view>

namespace rastertrace {

/// Somebody may cut the file short meanwhile: who looks at a byte that is gone is sent SIGBUS.
class MappedFile {
public:
    /// Maps a regular file. Throws a Problem that calls it by its name.
    static std::shared_ptr<const MappedFile> of(int descriptor, const std::string& name);

    MappedFile(const MappedFile&) = delete;
    MappedFile& operator=(const MappedFile&) = delete;
    ~MappedFile();

    /// What was there when it was mapped.
    std::string_view text() const { return {begin_, size_}; }

    /// Gives back the memory of the bytes that have been looked at. Looked at again, they come from the file.
    void forget() const;

private:
    MappedFile(const char* begin, std::size_t size) : begin_(begin), size_(size) {}

    const char* begin_;
    std::size_t size_;
};

} // namespace rastertrace
