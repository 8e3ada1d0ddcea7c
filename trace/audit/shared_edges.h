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

/// Compares every two triangles that share an edge, the first `most_compared` at each edge, in `jobs` threads. All of the
/// triangles need their samples.
std::vector<SharedEdge> compared_edges(const std::vector<Cornered>& triangles, std::size_t jobs,
                                       const CanvasSamples& grid);

/// Adds the T-junctions among the triangles that are drawn, which need their samples, to stats.t_junctions. An edge that one
/// of them shares with a triangle that is not drawn has no T-junctions.
void find_junctions(const std::vector<Cornered>& drawn, const std::vector<Cornered>& not_drawn,
                    const Trace& trace, const CanvasSamples& grid, Stats& stats);

} // namespace rastertrace
