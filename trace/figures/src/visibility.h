// SPDX-License-Identifier: MIT
#pragma once

// What is seen of the edges of a picture whose faces hide one another: by their depths, or by the painter's order.

#include "panel.h"

#include <array>
#include <cstddef>
#include <vector>

namespace rastertrace {

class Visibility {
public:
    /// Of the primitives so far. Nothing is hidden in a picture without a depth buffer and without a painter.
    explicit Visibility(const Panel& panel);

    /// False if a face in front of a primitive has that place of the panel.
    bool is_seen(std::size_t primitive, Place at) const;

    /// The parts of a side of a primitive that are seen; or, without `seen`, those that are not.
    std::vector<Path> parts_of(std::size_t primitive, const Path& side, bool seen) const;

private:
    /// A primitive on the sheet.
    struct Surface {
        std::size_t step;
        Path corners;
        std::array<double, 3>
            depth; ///< a x + b y + c, in what the depth buffer holds; 0 for a painter

        double depth_at(Place at) const { return depth[0] * at.x + depth[1] * at.y + depth[2]; }

        /// True of places inside, not on an edge.
        bool has(Place at) const;
    };

    bool is_before(const Surface& other, const Surface& own, Place at) const;

    /// The panel is cut into so many columns and rows, each of which knows the filled surfaces that may be in it: the
    /// others hide nothing.
    static constexpr int most_fields = 64;
    int column_of(double x) const;
    int row_of(double y) const;
    void add_to_fields(std::size_t surface);

    std::vector<Surface> surfaces_; ///< in the order of their steps
    std::vector<std::vector<std::size_t>> fields_ =
        std::vector<std::vector<std::size_t>>(most_fields * most_fields);
    Rectangle frame_;
    bool is_painted_ = false; ///< by a painter: the later one is in front
    bool larger_is_nearer_ = false;
    double cell_;
};

} // namespace rastertrace
