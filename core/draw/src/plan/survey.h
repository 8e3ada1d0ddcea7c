// SPDX-License-Identifier: MIT
#pragma once

// What the stages of pixels are decided from: which pixels each primitive may draw, and what
// differs between its corners.

#include <rastertrace/core/draw/list/screen_list.h>
#include <rastertrace/core/draw/scene/scene.h>

#include <algorithm>
#include <cstdint>
#include <vector>

namespace rastertrace {

/// A rectangle of pixels: columns from `left` to `right`, rows from `top` to `bottom` counted from
/// the top of the picture, all four included. Sides far beyond any canvas are kept within +-2^30.
struct PixelBox {
    std::int32_t left = 0;
    std::int32_t top = 0;
    std::int32_t right = -1;
    std::int32_t bottom = -1;

    bool operator==(const PixelBox&) const = default;
    bool is_empty() const { return right < left || bottom < top; }
    bool contains(const PixelBox& other) const { return intersected(other) == other; }
    PixelBox intersected(const PixelBox& other) const {
        return {std::max(left, other.left), std::max(top, other.top), std::min(right, other.right),
                std::min(bottom, other.bottom)};
    }
    PixelBox joined(const PixelBox& other) const {
        return is_empty() ? other
                          : PixelBox{std::min(left, other.left), std::min(top, other.top),
                                     std::max(right, other.right), std::max(bottom, other.bottom)};
    }
    std::uint64_t area() const {
        return is_empty() ? 0
                          : static_cast<std::uint64_t>(right - left + 1) *
                                static_cast<std::uint64_t>(bottom - top + 1);
    }
};

inline PixelBox box_of(const Canvas& canvas) {
    return {canvas.left(), 0, canvas.right(), canvas.height - 1};
}

/// What the stages of a primitive's pixels are decided from.
struct PrimitiveSurvey {
    PrimitiveKind kind = PrimitiveKind::triangle;
    int pieces = 0;              ///< 0: it is not drawn, or has no stages of pixels
    PixelBox box = {};           ///< it draws no pixel outside of it
    bool is_shared = false;      ///< another primitive may draw a pixel of it: their boxes overlap
    bool has_safe_depth = false; ///< no depth of it can lose against a clear buffer
    bool w_differs = false;
    bool colors_differ = false;

    /// True if another primitive, or the clear buffer, may hide a pixel of it.
    bool may_be_hidden() const { return is_shared || !has_safe_depth; }
    /// True if it may draw a pixel twice, like the parts of a clipped triangle and the sides of an
    /// outline.
    bool has_parts() const { return pieces > 1; }
};

/// A survey of each primitive of the scene: of every triangle that is drawn; of points and lines if
/// depths are tested.
std::vector<PrimitiveSurvey> survey_of(const Scene& scene, const AnyScreenList& list);

} // namespace rastertrace
