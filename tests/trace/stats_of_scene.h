// SPDX-License-Identifier: MIT
#pragma once

#include "traces.h"

#include <rastertrace/trace/audit/stats.h>

#include <string>

namespace rastertrace {

/// What the trace of a scene amounts to.
inline Stats stats_of_scene(const Scene& scene) {
    return stats_of(trace_of(scene));
}

/// A header, and what a foreign rasterizer might write of a triangle behind it: its pixels from (0, 0) to (8, 8) are those
/// that `draws` says.
inline const std::string foreign_header =
    "{\"rastertrace\":1,\"canvas\":{\"width\":10,\"height\":10,\"origin\":\"top-left\"}}\n";
template <typename Draws>
std::string foreign_triangle(const std::string& name, const std::string& at, Draws draws) {
    std::string text =
        R"({"step":"primitive","kind":"triangle","name":")" + name + R"(","at":)" + at + "}\n";
    for (int y = 0; y <= 8; ++y)
        for (int x = 0; x <= 8; ++x)
            if (draws(x, y))
                text += R"({"step":"pixel","x":)" + std::to_string(x) + R"(,"y":)" +
                        std::to_string(y) + "}\n";
    return text;
}

} // namespace rastertrace
