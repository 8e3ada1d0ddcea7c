// SPDX-License-Identifier: MIT
#pragma once

// What `rastertrace diff` is asked, of two files or of two folders.

#include "app/exit_status.h"
#include "frames/terminal_text.h"

#include <rastertrace/trace/compare/diff.h>
#include <rastertrace/trace/scene/scene_file.h>
#include <rastertrace/trace/text/input.h>
#include <rastertrace/trace/text/method_names.h>

#include <optional>
#include <string>
#include <vector>

namespace rastertrace {

struct DiffCommand {
    std::vector<std::string> files; ///< two scenes or traces; or one scene, and `against`
    std::string against;            ///< METHOD: the only scene, drawn by another one
    DiffOptions options;
    std::optional<Color> background{}; ///< of a picture: what is not drawn
    bool json = false;
    ColorChoice color = ColorChoice::automatic;
    bool is_quiet = false; ///< remarks on scenes are told nobody
    MethodOverrides method;
    InputLimits input;
    FrameChoice frames;
};
int run(const DiffCommand& command);

/// What the two files do differently, with the goldens that are accepted besides the first. Throws a Problem.
TraceDiff diff_of_files(const DiffCommand& command);

/// Compares the files of two folders that have one name. Throws a Problem if there are none.
ExitStatus diff_folders(const DiffCommand& command);

} // namespace rastertrace
