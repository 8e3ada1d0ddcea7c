// SPDX-License-Identifier: MIT
#pragma once

// What rapidcheck makes up for properties of triangles, and what it says of a scene that fails.
//
//     const Scene scene = triangle_scene(any_triangle(150, 12), canvas);
//     log_scene(scene);

#include "scene_text.h"

#include <rapidcheck.h>

#include <cstdint>
#include <string>
#include <vector>

namespace rastertrace {

/// Six coordinates of up to `farthest` parts on either side of 0, `parts` to a pixel.
inline std::vector<std::string> any_triangle(std::int64_t farthest, std::int64_t parts) {
    std::vector<std::string> coordinates;
    for (int i = 0; i < 6; ++i)
        coordinates.push_back(
            std::to_string(*rc::gen::inRange<std::int64_t>(-farthest, farthest + 1)) + "/" +
            std::to_string(parts));
    return coordinates;
}

/// If the property fails, the scene is printed: save it as a file, and `rastertrace show` draws it.
inline void log_scene(const Scene& scene) {
    RC_LOG() << scene_text(scene);
}

} // namespace rastertrace
