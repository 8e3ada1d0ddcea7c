// SPDX-License-Identifier: MIT
#pragma once

// What the answers to all questions are made of.

#include <rastertrace/trace/explain.h>
#include <rastertrace/trace/frame.h>

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

namespace rastertrace {

/// The current step of a replay.
Try try_of(const Replay& replay);

/// What a pixel shows after the current step of a replay: `ABC #000000`, `background #ffffff` or `empty`.
std::string shown_at(const Replay& replay, Pixel pixel);

/// Some steps of a trace, by number, in order.
std::vector<Try> tries_of(const Trace& trace, const std::vector<std::size_t>& steps);

/// The steps of a primitive of that name, or of the parts that clipping has made of it.
bool is_part_of(std::string_view name, std::string_view whole);

/// Answers by topic. A name that is not there is thrown as a Problem.
Explanation explain_pixel(const Trace& trace, Pixel pixel);
Explanation explain_scanline(const Trace& trace, int y);
Explanation explain_face(const Trace& trace, const std::string& name);
Explanation explain_vertex(const Trace& trace, const std::string& name);
Explanation explain_edge(const Trace& trace, const std::string& name);
Explanation explain_pair(const Trace& trace, const std::string& names);

} // namespace rastertrace
