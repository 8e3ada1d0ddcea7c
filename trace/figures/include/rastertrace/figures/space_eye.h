// SPDX-License-Identifier: MIT
#pragma once

// From where the picture in space is seen.

#include <array>
#include <optional>
#include <string_view>
#include <vector>

namespace rastertrace {

/// Parallel lines of sight come from this direction.
struct SpaceEye {
    /// 35 degrees around y, and 20 degrees of height.
    std::array<double, 3> direction{0.5390, 0.3420, 0.7698};
    /// z is toward where the scene's camera stands, not along its own axis; and it is seen from the other side if
    /// that would show one of its few faces as a line
    bool is_named = true;
};

/// corner, front, side, top
std::vector<std::string_view> space_eye_names();
std::optional<SpaceEye> space_eye_named(std::string_view name);

} // namespace rastertrace
