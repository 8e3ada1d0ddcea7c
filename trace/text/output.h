// SPDX-License-Identifier: MIT
#pragma once

// Where bytes go: a string, standard output, or a file that gets its name only when it is complete.
//
//     FileOutputs files;
//     files.open("a.svg").write(svg);
//     files.commit();

#include "descriptor.h"
#include "problem.h"

#include <deque>
#include <optional>
#include <string>
#include <string_view>
#include <unordered_map>

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

/// Writes a file. A regular file is written beside its final place, and takes the final name in
/// `commit`: until then, and if `commit` is never called, an older file of that name stays as it
/// was. It replaces the file that a symbolic link leads to, not the link, and keeps the mode of the
/// older file. A device or pipe is written directly.
class FileOutput final : public Output {
public:
    /// Opens the file; throws a Problem if that cannot be done, or if it is one that has been read (process_files.h),
    /// which would be lost.
    explicit FileOutput(const std::string& path);
    FileOutput(const FileOutput&) = delete;
    FileOutput& operator=(const FileOutput&) = delete;
    ~FileOutput() override;

    void write(std::string_view bytes) override;

    /// Sees the bytes to the disk and gives the file its name; throws a Problem if that fails, or if the file that is there
    /// has been read by then.
    void commit();

private:
    friend class FileOutputs;

    void open_beside_target(std::optional<unsigned> mode);
    void sync();
    void take_name();

    /// The same for all that would replace or create one regular file; "" of a device or pipe.
    std::string identity() const;

    std::string path_;            ///< as the user wrote it
    std::optional<FileId> older_; ///< the file that is replaced
    Descriptor folder_;           ///< of the final place, links followed; closed for a device
    FileId folder_id_;
    std::string name_;      ///< the final name in the folder
    std::string temporary_; ///< the name it is written under; empty if it has none
    Descriptor file_;
};

/// Writes a whole file, as FileOutput does.
void write_file(const std::string& path, std::string_view bytes);

/// Makes a folder with all that leads to it, if it is not there; where outputs go elsewhere, there. Throws a Problem, also
/// if a command of a page would make it outside of the current folder.
void make_folder(const std::string& path);

/// Files that get their names together.
class FileOutputs {
public:
    /// Opens one more, as FileOutput does. Throws a Problem also if it is one of those before it.
    FileOutput& open(const std::string& path);

    /// Gives all of them their names, in this order, once the bytes of all are on the disk. Signals wait until the last
    /// one has its name. Throws a Problem if something fails; it lists which files are new by then.
    void commit();

private:
    std::deque<FileOutput> files_;
    std::unordered_map<std::string, std::string> paths_; ///< by identity
};

} // namespace rastertrace
