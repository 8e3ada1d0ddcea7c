// SPDX-License-Identifier: MIT
#pragma once

// What a picture shows otherwise than a trace draws it: by pixels, with the primitives of the trace.
//
//     const TraceDiff found = diff_with_picture(trace, picture, {.name = "mine.png"});

#include "picture.h"

#include <rastertrace/trace/compare/diff.h>
#include <rastertrace/trace/record/trace.h>

#include <optional>
#include <string>

namespace rastertrace {

/// How a picture is compared. What has the `background` is not drawn; if none is given and nothing is transparent, it is
/// the trace's, or the color that most of the pixels have that the trace does not draw.
struct PictureDiffOptions {
    std::string name{};            ///< of the picture
    bool is_picture_first = false; ///< it is a, the trace is b
    bool compares_colors = true;   ///< if the picture has any
    std::optional<Color> background{};
    int color_tolerance = 0; ///< so far apart may levels of a channel be
};

/// What options of a comparison say of pictures: a tolerance of pixel.color, or that it is ignored. Throws a Problem.
PictureDiffOptions picture_options(const DiffOptions& options);

/// Compares the final picture of a trace with another one, which has to be of its size. A remark says where another
/// place or direction of the picture would explain (nearly) all. Throws a Problem.
TraceDiff diff_with_picture(const Trace& trace, const Picture& picture,
                            const PictureDiffOptions& options);

} // namespace rastertrace
