// SPDX-License-Identifier: MIT
#pragma once

// Files that are open, see process_files.h.

#include "descriptor.h"

#include <string>

namespace rastertrace {

/// Adds a file to opened_files().
void note_opened(const FileId& file);

/// The path by which a file that is open can be named once more.
std::string path_of_open(const Descriptor& file);

/// Where an open file or folder is, without symbolic links; "" if it has no name, or too long a one.
std::string place_of_open(const Descriptor& file);

} // namespace rastertrace
