// SPDX-License-Identifier: MIT
#pragma once

// What `rastertrace figure` is asked.

#include "commands/figure_file.h"

#include <rastertrace/figures/figure.h>
#include <rastertrace/figures/space_frames.h>
#include <rastertrace/trace/scene/scene_file.h>
#include <rastertrace/trace/text/input.h>
#include <rastertrace/trace/text/method_names.h>

#include <cstddef>
#include <optional>
#include <string>

namespace rastertrace {

struct FigureCommand {
    enum class Which {
        last,
        step,
        until,
        every,
        film, ///< see film_of
    };

    /// Frames in rows and columns on one sheet.
    struct Sheet {
        std::size_t columns;
        std::size_t rows;
    };

    std::string trace;
    std::string output;
    std::optional<FigureFormat> format; ///< none: by the name of the output
    Which which = Which::last;
    std::string selector; ///< for all but Which::last
    FigureOptions options;
    FigureStyle style;
    std::optional<Sheet> sheet;
    std::optional<SpaceFrames> frames_in_space; ///< in the place of all other pictures
    bool is_animated = false;                   ///< all frames in one .svg
    bool is_bare = false;                       ///< only the pixels
    std::string against;                        ///< METHOD, or a file: see FigureOptions
    MethodOverrides method;
    InputLimits input;
    FrameChoice frames;
};
int run(const FigureCommand& command);

} // namespace rastertrace
