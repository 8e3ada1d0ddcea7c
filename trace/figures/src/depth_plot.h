// SPDX-License-Identifier: MIT
#pragma once

// Depths along a row of a triangle, or along its side from row to row: z and 1/z as they were drawn, and as they are in
// truth. On a picture in perspective 1/z is linear, and z is not.

#include "panel.h"

#include <rastertrace/figures/plot.h>

#include <optional>
#include <vector>

namespace rastertrace {

/// One plot for z and one for 1/z. Nothing if the frame's triangle has no depths, or depths that are neither.
std::vector<Plot> depth_plots(const Panel& panel);

} // namespace rastertrace
