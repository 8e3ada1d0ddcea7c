// SPDX-License-Identifier: MIT
#pragma once

// What triangles drew where one ends and the next begins: at an edge that they share, and at vertices on an edge of
// another one.

#include "cornered.h"
#include "stats.h"
#include "triangle_samples.h"

#include <rastertrace/trace/record/trace.h>

#include <cstddef>
#include <vector>

namespace rastertrace {

/// Every pair of the triangles at every edge that they share, the first `most_compared` at each. They have samples. In so
/// many threads.
std::vector<SharedEdge> compared_edges(const std::vector<Cornered>& triangles, std::size_t jobs,
                                       const CanvasSamples& grid);

/// Adds the T-junctions among the triangles that are drawn, which have samples, to stats.t_junctions. The edges of those
/// that are not drawn count too: whoever shares one has a neighbor.
void find_junctions(const std::vector<Cornered>& drawn, const std::vector<Cornered>& not_drawn,
                    const Trace& trace, const CanvasSamples& grid, Stats& stats);

} // namespace rastertrace
