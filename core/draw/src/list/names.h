// SPDX-License-Identifier: MIT
#pragma once

#include <rastertrace/core/draw/list/pieces.h>

#include <cstddef>
#include <span>
#include <string>

namespace rastertrace {

/// What a vertex is called that clipping has made.
inline std::string name_of_made(const std::string& primitive, int ordinal) {
    return primitive + ":" + std::to_string(ordinal);
}

/// Places in the list of the corners of a primitive, or of a part of one.
template <typename Scalar>
std::span<const std::size_t> corners_of(const Scene& scene, const ScreenList<Scalar>& list,
                                        const ScreenPrimitive& one) {
    const auto corners = scene.primitives[one.primitive].corners();
    if (one.state != ScreenPrimitive::State::part)
        return corners;
    const bool is_line = scene.primitives[one.primitive].kind == PrimitiveKind::outline;
    return std::span(list.parts[one.index].corners).first(is_line ? 2 : corners.size());
}

} // namespace rastertrace
