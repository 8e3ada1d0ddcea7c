// SPDX-License-Identifier: MIT
#pragma once

// The files of this process: which it has opened to be read, and where they may lie.
//
//     set_file_rules({.below = "/home/me/pages", .outputs = {}});  // before the first file is opened
//     FileOutput output(path, opened_files());                     // nothing that was read is lost

#include "descriptor.h"

#include <cstdint>
#include <string>
#include <vector>

namespace rastertrace {

/// The regular files that have been opened to be read since the process began, whoever named them. Not to be asked for
/// while other threads open files.
const std::vector<FileId>& opened_files();

/// How many bytes of traces the process has gone through, and how many bytes of files it has written; another thread may
/// ask for it, to show the progress.
struct BytesDone {
    std::uint64_t read = 0;
    std::uint64_t written = 0;
};
BytesDone bytes_done();
void add_bytes_done(const BytesDone& more);

/// Where the files of a process may lie.
struct FileRules {
    /// Files are read and written only below this folder: an absolute path without symbolic links. Links in the path of
    /// a file are followed first. "": anywhere.
    std::string below;

    /// A file is written below this folder instead, under the whole path that it would have; "": at its place.
    std::string outputs;
};

/// Rules for all files that are opened from then on. (Standard input and output are no files.)
void set_file_rules(FileRules rules);
const FileRules& file_rules();

} // namespace rastertrace
