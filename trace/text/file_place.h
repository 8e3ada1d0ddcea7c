// SPDX-License-Identifier: MIT
#pragma once

// Files that are open, see process_files.h.

#include "descriptor.h"

#include <string>

namespace rastertrace {

/// For refuse_opened: a file was opened by a path, or written.
void note_opened(const FileId& file, const std::string& path);

/// The path by which a file that is open can be named once more.
std::string path_of_open(const Descriptor& file);

} // namespace rastertrace
