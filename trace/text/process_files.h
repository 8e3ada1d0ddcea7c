// SPDX-License-Identifier: MIT
#pragma once

// The files of this process: which it has opened to be read, and where it writes.
//
//     refuse_opened(id, path);  // nothing that was read is lost

#include "descriptor.h"

#include <cstdint>
#include <span>
#include <string>

namespace rastertrace {

/// Throws a Problem if a file that is to be written has been opened to be read since the process began, whoever named it.
void refuse_opened(const FileId& file, const std::string& name);

/// The files that are opened while it lives are read to be replaced: once it is gone, that they were opened does not count.
/// There is one at a time.
class ReadToReplace {
public:
    ReadToReplace();
    ReadToReplace(const ReadToReplace&) = delete;
    ReadToReplace& operator=(const ReadToReplace&) = delete;
    ~ReadToReplace();
};

/// How many bytes of traces the process has gone through, and how many bytes of files it has written; another thread may
/// ask for it, to show the progress.
struct BytesDone {
    std::uint64_t read = 0;
    std::uint64_t written = 0;
};
BytesDone bytes_done();
void add_bytes_done(const BytesDone& more);

/// This process runs a command of a page: from then on it makes folders below the current one only, and writes files below
/// `folder` instead, under the whole path that they would have; "": at their place. `pages` count as opened: the program that
/// has started this one reads them.
void run_for_page(std::string folder, std::span<const std::string> pages);
bool runs_for_page();
std::string folder_of_outputs();

} // namespace rastertrace
