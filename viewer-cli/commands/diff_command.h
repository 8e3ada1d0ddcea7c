// SPDX-License-Identifier: MIT
#pragma once

// How `rastertrace diff` compares two files, or two folders.

#include "app/exit_status.h"
#include "app/load.h"
#include "frames/terminal_text.h"

#include <rastertrace/trace/compare/diff.h>

#include <optional>
#include <string>
#include <vector>

namespace rastertrace {

struct FileComparison {
    DiffOptions options;
    std::optional<Color> background; ///< of a picture: what is not drawn
    SceneOptions scenes;
};

/// What two files do differently, with the goldens that are accepted besides the first. Throws a Problem.
TraceDiff diff_of_files(const std::string& path_a, const std::string& path_b,
                        const FileComparison& how);

/// Compares the files of two folders that have one name; prints JSON, or text. Throws a Problem if there are none.
ExitStatus diff_folders(const std::vector<std::string>& folders, FileComparison how, bool as_json,
                        ColorChoice color);

} // namespace rastertrace
