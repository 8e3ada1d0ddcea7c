// SPDX-License-Identifier: MIT
#pragma once

// Where clipping has cut an edge.
//
//     if (const auto meeting = meeting_point_of(step))
//         meeting->plane;  // "near"

#include <rastertrace/core/numbers/rational.h>
#include <rastertrace/trace/record/step_context.h>

#include <optional>
#include <string>

namespace rastertrace {

/// A vertex that lies on a plane of the view, at `inside` + t (`outside` - `inside`) in clip space.
struct MeetingPoint {
    std::string plane;   ///< near, far, left, right, bottom, top
    std::string inside;  ///< the vertex at one end of the edge that was cut
    std::string outside; ///< and the one at the other end
    Rational t;
};

/// That of a step, of a vertex in clip space; nothing if clipping did not make it, or if the edge
/// is not found that meets a plane there.
std::optional<MeetingPoint> meeting_point_of(const StepContext& step);

} // namespace rastertrace
