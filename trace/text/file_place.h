// SPDX-License-Identifier: MIT
#pragma once

// Files that are open, see process_files.h.

#include "descriptor.h"

#include <optional>
#include <string>

namespace rastertrace {

/// Which file a path leads to; nullopt if that is no regular file.
std::optional<FileId> file_at(const std::string& path);

/// For refuse_opened: a file was opened by a path, or written.
void note_opened(const FileId& file, const std::string& path);
void note_written(const FileId& file);

/// The path by which a file that is open can be named once more.
std::string path_of_open(const Descriptor& file);

} // namespace rastertrace
