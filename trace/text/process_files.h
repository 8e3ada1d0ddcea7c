// SPDX-License-Identifier: MIT
#pragma once

// The files of this process: which it has opened to be read, and where it writes.
//
//     FileOutput output(path, opened_files());  // nothing that was read is lost

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

/// From then on files are written below this folder instead, under the whole path that they would have; "": at their
/// place.
void write_files_below(std::string folder);
const std::string& folder_of_outputs();

} // namespace rastertrace
