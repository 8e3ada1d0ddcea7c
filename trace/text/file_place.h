// SPDX-License-Identifier: MIT
#pragma once

// Files opened by the rules of the process, see process_files.h.

#include "descriptor.h"

#include <string>

namespace rastertrace {

/// Adds a file to opened_files().
void note_opened(const FileId& file);

/// Opens a file that is there, as open(2) does: closed, with errno set, if that fails. Throws a Problem if the rules do
/// not let the file be opened.
Descriptor open_by_rules(const std::string& path, int flags);

/// Throws a Problem about `path`, as the user wrote it, if the rules do not let a file of this name lie in a folder.
void refuse_outside(const Descriptor& folder, const std::string& name, const std::string& path);

/// The path by which a file that is open can be named once more.
std::string path_of_open(const Descriptor& file);

/// Where an open file or folder is, without symbolic links; "" if it has no name, or too long a one.
std::string place_of_open(const Descriptor& file);

} // namespace rastertrace
