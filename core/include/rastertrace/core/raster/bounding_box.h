// SPDX-License-Identifier: MIT
#pragma once

// The bounding box of a triangle: the pixels that a fill tests one by one.
//
//     for (const Pixel pixel : ...)  // box.first_row to box.last_row, box.first_x to box.last_x

#include <rastertrace/core/numbers/scalar.h>
#include <rastertrace/core/raster/canvas.h>
#include <rastertrace/core/raster/sample_offset.h>
#include <rastertrace/core/raster/triangle.h>

#include <algorithm>

namespace rastertrace {

/// Columns and rows of a canvas, both ends included; rows are counted from the top of the picture.
struct BoundingBox {
    Index first_x;
    Index last_x;
    Index first_row;
    Index last_row;

    bool is_empty() const { return last_x < first_x || last_row < first_row; }
};

/// The pixels of the canvas whose samples lie between the smallest and the largest x and y of a
/// triangle.
template <typename Scalar>
BoundingBox bounding_box(const Triangle<Scalar>& triangle, const SampleOffset<Scalar>& offset,
                         const Canvas& canvas) {
    const auto& [a, b, c] = triangle.vertices;
    const Index left = ceil_index(Scalar(std::min({a.x, b.x, c.x}) - offset.x()));
    const Index right = floor_index(Scalar(std::max({a.x, b.x, c.x}) - offset.x()));
    const Index low = ceil_index(Scalar(std::min({a.y, b.y, c.y}) - offset.y()));
    const Index high = floor_index(Scalar(std::max({a.y, b.y, c.y}) - offset.y()));
    const Index top_row = canvas.row_of(canvas.down() > 0 ? low : high);
    const Index bottom_row = canvas.row_of(canvas.down() > 0 ? high : low);
    return {std::max<Index>(left, canvas.left()), std::min<Index>(right, canvas.right()),
            std::max<Index>(top_row, 0), std::min<Index>(bottom_row, canvas.height - 1)};
}

/// Calls `visit(pixel)` with the pixels of a box, top row first, from left to right.
template <typename Visit>
void for_each_pixel(const BoundingBox& box, const Canvas& canvas, Visit&& visit) {
    for (Index row = box.first_row; row <= box.last_row; ++row)
        for (Index x = box.first_x; x <= box.last_x; ++x)
            visit(Pixel{static_cast<int>(x), canvas.y_of(static_cast<int>(row))});
}

} // namespace rastertrace
