// SPDX-License-Identifier: MIT
#pragma once

// A file, a pipe or standard input, read block by block.
//
//     auto file = InputFile::open("trace.jsonl");  // or "-"
//     while (file.value().read_into(text)) ...

#include "descriptor.h"
#include "problem.h"

#include <cstddef>
#include <optional>
#include <string>

namespace rastertrace {

class InputFile {
public:
    /// What a path may lead to.
    enum class Kind {
        any,          ///< also a pipe or a device; "-" is standard input
        regular_file, ///< nothing else
    };

    /// Opens a file. That it is not there, or a folder, is a problem.
    static Result<InputFile> open(const std::string& path, Kind kind = Kind::any);

    /// A file that is open already, from where it is read next.
    InputFile(std::string name, Descriptor file)
        : name_(std::move(name)), file_(std::move(file)), descriptor_(file_.number()) {}

    /// What messages call it.
    const std::string& name() const { return name_; }

    /// Which one it is, if it is a regular file.
    const std::optional<FileId>& id() const { return id_; }

    /// How many bytes the system says that a regular file has, as a hint: it may have more or fewer. Else 0.
    std::size_t told_size() const { return told_size_; }

    /// Its descriptor, which stays open as long as this lives.
    int descriptor() const { return descriptor_; }

    /// Adds the next block to a text; false at the end. Throws a Problem.
    bool read_into(std::string& text);

private:
    InputFile(std::string name, Descriptor file, int descriptor)
        : name_(std::move(name)), file_(std::move(file)), descriptor_(descriptor) {}

    std::string name_;
    Descriptor file_; ///< closed for standard input
    int descriptor_;
    std::optional<FileId> id_;
    std::size_t told_size_ = 0;
};

} // namespace rastertrace
