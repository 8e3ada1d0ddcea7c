// SPDX-License-Identifier: MIT
#pragma once

// The picture of a scene's text, and the line that a faulty one is refused with.

#include "traces.h"

#include <rastertrace/core/draw/draw.h>

#include <gtest/gtest.h>

#include <string>
#include <vector>

namespace rastertrace {

inline std::vector<Color> colors_of(const std::string& text) {
    const auto read = read_scene({"scene", text});
    if (!read) {
        ADD_FAILURE() << to_text(read.problem());
        return {};
    }
    const Image image = draw(read.value().scene, read.value().plan);
    return {image.colors().begin(), image.colors().end()};
}

/// `line:column: message` of what a text is refused with; "" if it is a scene.
inline std::string fault_of(const std::string& text) {
    const auto read = read_scene({"t", text});
    return read ? "" : to_text(read.problem()).substr(2, to_text(read.problem()).find('\n') - 2);
}

} // namespace rastertrace
