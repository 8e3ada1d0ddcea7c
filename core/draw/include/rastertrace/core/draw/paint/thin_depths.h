// SPDX-License-Identifier: MIT
#pragma once

// Points and lines that have been drawn, beside the depth buffer of the faces: so no line takes a face away
// from the next one, and which pixels lines have does not depend on their order.

#include <rastertrace/core/raster/steps.h>

#include <cstddef>
#include <cstdint>
#include <string_view>
#include <unordered_map>

namespace rastertrace {

/// Of equal depths the thinner primitive passes.
enum class Thickness : std::uint8_t { point, line, face };

inline Thickness thickness_of(PrimitiveKind kind) {
    switch (kind) {
    case PrimitiveKind::point:
        return Thickness::point;
    case PrimitiveKind::line:
    case PrimitiveKind::outline:
        return Thickness::line;
    case PrimitiveKind::triangle:
        break;
    }
    return Thickness::face;
}

/// What was decided about a pixel, as in DepthTested.
struct DepthVerdict {
    bool passes;
    DepthReason reason = DepthReason::stored;
    std::string_view other = {};
    bool is_by_thin =
        false;             ///< a point or a line in the pixel has decided, even if a face is nearer
    bool is_exact = false; ///< with `adaptive`: doubles have left it open
};

/// The nearest point or line of each cell of a depth buffer that has one.
template <typename Depth> class ThinDepths {
public:
    /// A point or a line, as it was drawn in a pixel.
    struct Thin {
        Depth depth; ///< turned
        Thickness thickness;
        std::uint32_t owner; ///< which of those that are drawn
    };

    const Thin* find(std::size_t cell) const {
        const auto found = of_cells_.empty() ? of_cells_.end() : of_cells_.find(cell);
        return found == of_cells_.end() ? nullptr : &found->second;
    }

    bool is_empty() const { return of_cells_.empty(); }

    void keep(std::size_t cell, const Thin& thin) { of_cells_[cell] = thin; }

private:
    std::unordered_map<std::size_t, Thin> of_cells_;
};

} // namespace rastertrace
