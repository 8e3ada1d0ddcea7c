// SPDX-License-Identifier: MIT
#pragma once

// The keys of a trace's header and of its end record; those of its steps are in step_kind.h. A reader takes other
// keys too: a foreign rasterizer may add its own. The schema of traces is written from these tables, and
// `validate` holds headers against them.
//
//     for (const JsonKey& key : header_keys) ...

#include <rastertrace/trace/text/json_key.h>

#include <array>

namespace rastertrace {

inline constexpr std::array header_keys{
    JsonKey{"rastertrace", "version", "The version of the format", true},
    JsonKey{"title", "string", "Shown above every frame; that of the scene"},
    JsonKey{"canvas", "canvas", "The grid of pixels", true},
    JsonKey{"background", "color", "How views show the pixels that nothing draws"},
    JsonKey{"method", "method", "Every choice that the picture can depend on"},
    JsonKey{"numbers", "string", "The numbers that were drawn with, where the plan chooses them"},
    JsonKey{"projection", "string", "How camera space came to the view plane"},
    JsonKey{"viewport", "string", "How the view plane came to the canvas"},
    JsonKey{"matrices", "string", "What exact arithmetic took of entries that no fraction is"},
    JsonKey{"stages", "stages", "Which stages of drawing ran, and why"},
    JsonKey{"only", "strings", "Of the steps, only these kinds were written"},
    JsonKey{"region", "region", "Of the steps, only those about these pixels: x0, y0, x1, y1"},
    JsonKey{"primitive", "string", "Of the steps, only those of this primitive were written"},
};

inline constexpr std::array stage_keys{
    JsonKey{"stage", "string", "The stage", true},
    JsonKey{"plane", "string", "Of clipping: the plane"},
    JsonKey{"kept", "boolean", "False if it was left out: it could not change the picture", true},
    JsonKey{"why", "string", "The reason"},
};

inline constexpr std::array end_keys{
    JsonKey{"steps", "count", "How many steps were written"},
    JsonKey{"count", "counts", "How many of each kind"},
    JsonKey{"pixels", "count", "How many different pixels the picture has"},
    JsonKey{"frame", "string", "The name of the picture: FNV-1a of its pixels"},
};

} // namespace rastertrace
