// SPDX-License-Identifier: MIT
#pragma once

// Where bytes go: a string, standard output, or a file that gets its name only when it is complete.

#include <rastertrace/trace/problem.h>

#include <optional>
#include <string>
#include <string_view>

namespace rastertrace {

/// Takes bytes. `write` throws a Problem when they cannot be kept.
class Output {
public:
    virtual ~Output() = default;
    virtual void write(std::string_view bytes) = 0;
};

/// Collects bytes in a string.
class StringOutput final : public Output {
public:
    explicit StringOutput(std::string& text) : text_(text) {}
    void write(std::string_view bytes) override { text_ += bytes; }

private:
    std::string& text_;
};

/// Writes to an open file descriptor, such as standard output, which it does not close.
class DescriptorOutput final : public Output {
public:
    DescriptorOutput(int descriptor, std::string name)
        : descriptor_(descriptor), name_(std::move(name)) {}
    void write(std::string_view bytes) override;

private:
    int descriptor_;
    std::string name_;
};

/// Writes a file. A regular file is written beside its final place under another name, and takes
/// the final name in `commit`: until then, and if `commit` is never called, an older file of that
/// name stays as it was. A device or pipe is written directly.
class FileOutput final : public Output {
public:
    /// Opens the file; throws a Problem if that cannot be done.
    explicit FileOutput(const std::string& path);
    FileOutput(const FileOutput&) = delete;
    FileOutput& operator=(const FileOutput&) = delete;
    ~FileOutput() override;

    void write(std::string_view bytes) override;

    /// Closes the file and gives it its name; throws a Problem if that fails.
    void commit();

private:
    std::string path_;      ///< as the user wrote it
    std::string target_;    ///< the final place, links followed
    std::string temporary_; ///< the name it is written under; empty for a device or pipe
    int descriptor_ = -1;
};

} // namespace rastertrace
