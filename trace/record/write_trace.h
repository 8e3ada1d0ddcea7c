// SPDX-License-Identifier: MIT
#pragma once

// Draws a scene and writes its trace, as a stream: header, one line per step, end record.
//
//     std::string text;
//     StringOutput out(text);
//     write_trace(scene, {}, out);

#include "trace_options.h"

#include <rastertrace/core/draw/plan/plan.h>
#include <rastertrace/core/draw/scene/scene.h>
#include <rastertrace/core/raster/image.h>
#include <rastertrace/trace/text/output.h>
#include <rastertrace/trace/text/problem.h>

#include <cstddef>
#include <cstdint>
#include <limits>
#include <string>

namespace rastertrace {

/// The version of the trace format that is written, and the newest that is read.
inline constexpr int trace_version = 1;

/// Draws the scene by its plan and writes its trace. The same scene and options give the same bytes
/// on every machine. Returns how many steps it wrote. Throws the Problem that the output throws.
std::uint64_t write_trace(const Scene& scene, const Plan& plan, const TraceOptions& options,
                          Output& output);

/// The same for a scene that nobody has planned yet.
std::uint64_t write_trace(const Scene& scene, const TraceOptions& options, Output& output);

/// What stands around the steps: the members of the header, and of the end record, without the braces around them.
std::string header_members(const Scene& scene, const Plan& plan, const StepFilter& filter);
std::string end_record(const KindCounts& count, const Image& image);

/// The name that a trace gives to a final picture: FNV-1a (64 bit, sixteen hexadecimal digits) over
/// the red, green, blue and alpha byte of every pixel, row by row from the top; a pixel that
/// nothing has drawn is four zero bytes.
std::string frame_name(const Image& image);

} // namespace rastertrace
