// SPDX-License-Identifier: MIT
#pragma once

// The picture in space: the scene as somebody sees it who stands beside its camera, with the eye, the view plane and
// what a step is about.
//
//     if (const auto space = space_of(trace))
//         drawing = space_drawing(*space, trace, {}, {400, 300}, nullptr);

#include "space_sheet.h"

#include <utility>

namespace rastertrace {

/// Of what the current step of a replay is about, the rest pale; without a replay, of the whole scene.
Drawing space_drawing(const SpatialScene& space, const Trace& trace, const SpaceEye& eye,
                      std::pair<double, double> size, const Replay* replay);

} // namespace rastertrace
