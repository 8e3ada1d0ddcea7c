// SPDX-License-Identifier: MIT
#pragma once

// The depths of points and lines. They are not kept in the depth buffer of the faces: there, a line
// would hide the face that the next line is tested against, and the result would depend on the
// order of the lines.

#include <rastertrace/core/draw/scene/algorithms.h>
#include <rastertrace/core/raster/steps.h>

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string_view>
#include <unordered_map>

namespace rastertrace {

/// The result of a depth test, as DepthTested has it.
struct DepthVerdict {
    bool passes;
    std::optional<std::string_view> side_of = {};
    std::optional<std::string_view> beside = {};
    std::optional<std::string_view> behind = {};
    bool is_by_thin = false; ///< by a point or a line in the pixel, even if a face is nearer
};

/// The nearest point or line of each cell of a depth buffer, if there is one.
template <typename Depth> class ThinDepths {
public:
    /// A point or a line in a pixel.
    struct Thin {
        Depth depth; ///< turned
        Thickness thickness;
        std::uint32_t owner; ///< as in DepthTests::begin
    };

    const Thin* find(std::size_t cell) const {
        const auto found = of_cells_.empty() ? of_cells_.end() : of_cells_.find(cell);
        return found == of_cells_.end() ? nullptr : &found->second;
    }

    void keep(std::size_t cell, const Thin& thin) { of_cells_[cell] = thin; }

private:
    std::unordered_map<std::size_t, Thin> of_cells_;
};

} // namespace rastertrace
