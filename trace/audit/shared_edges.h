// SPDX-License-Identifier: MIT
#pragma once

// What triangles drew where one ends and the next begins: at an edge that they share.

#include "cornered.h"
#include "stats.h"
#include "triangle_samples.h"

#include <cstddef>
#include <vector>

namespace rastertrace {

/// Compares every two triangles that share an edge, the first `most_compared` at each edge.
std::vector<SharedEdge> compared_edges(const std::vector<Cornered>& triangles,
                                       const CanvasSamples& grid);

} // namespace rastertrace
