// SPDX-License-Identifier: MIT
#pragma once

// Which lines are sides of which faces.

#include <rastertrace/core/draw/scene/scene.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>

namespace rastertrace {

/// True if the line between two vertices is a side of a primitive, or of the polygon that it is a
/// part of. If both vertices are the same: if that is one of its corners. A side of a polygon is a
/// side of one of its triangles, a diagonal of two.
inline bool is_side_of(const Scene& scene, const std::array<std::size_t, 2>& ends,
                       std::size_t primitive) {
    const auto& all = scene.primitives;
    const auto has = [&](std::size_t i, std::size_t vertex) {
        const auto corners = all[i].corners();
        return std::find(corners.begin(), corners.end(), vertex) != corners.end();
    };
    const std::uint32_t polygon = all[primitive].polygon;
    if (polygon == 0)
        return has(primitive, ends[0]) && has(primitive, ends[1]);
    std::size_t i = primitive;
    while (i > 0 && all[i - 1].polygon == polygon)
        --i;
    std::size_t count = 0;
    for (; i < all.size() && all[i].polygon == polygon; ++i)
        count += has(i, ends[0]) && has(i, ends[1]) ? 1 : 0;
    return ends[0] == ends[1] ? count > 0 : count == 1;
}

} // namespace rastertrace
