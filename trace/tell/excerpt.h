// SPDX-License-Identifier: MIT
#pragma once

// A part of a trace as a trace of its own: the steps of some kinds, as `rastertrace trace --only` writes them of a
// scene. Whose trace it is does not matter, nor which layout it has.
//
//     write_excerpt(trace, {"scanline", "pixel"}, TraceLayout::jsonl, output);

#include <rastertrace/trace/record/trace.h>
#include <rastertrace/trace/record/trace_options.h>

#include <rastertrace/trace/text/output.h>

#include <string>
#include <vector>

namespace rastertrace {

/// Writes the steps of these kinds, or of all if none is named, one a line. Throws a Problem if the trace is damaged, if it has left out steps of such a kind, or if the output cannot be written.
void write_excerpt(const Trace& trace, const std::vector<std::string>& kinds, TraceLayout layout,
                   Output& output);

} // namespace rastertrace
