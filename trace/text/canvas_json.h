// SPDX-License-Identifier: MIT
#pragma once

// The "canvas" of scenes and of trace headers.

#include "json_document.h"
#include "problem.h"

#include <rastertrace/core/raster/canvas.h>

#include <array>
#include <optional>
#include <span>
#include <string>
#include <string_view>

namespace rastertrace {

inline constexpr auto canvas_keys = std::to_array<std::string_view>({"width", "height", "origin"});

/// A canvas as it was written: a size may be missing.
struct CanvasJson {
    int width = 0;
    int height = 0;
    Origin origin = Origin::center;
    bool has_width = false;
    bool has_height = false;
};

/// Reads {"width", "height", "origin"}; every key may be left out, no other is allowed.
Result<CanvasJson> read_canvas_json(const Source& source, const JsonValue& value);

/// Why a canvas of this size is refused, if it is.
std::optional<std::string> fault_of_size(const Canvas& canvas);

/// The word of a scene's canvas for it: center, bottom-left or top-left.
std::string_view name_of(Origin origin);

/// All three words.
std::span<const std::string_view> origin_words();

} // namespace rastertrace
