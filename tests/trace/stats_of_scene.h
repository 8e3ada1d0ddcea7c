// SPDX-License-Identifier: MIT
#pragma once

#include "traces.h"

#include <rastertrace/trace/audit/stats.h>

namespace rastertrace {

/// What the trace of a scene amounts to.
inline Stats stats_of_scene(const Scene& scene) {
    return stats_of(trace_of(scene));
}

} // namespace rastertrace
