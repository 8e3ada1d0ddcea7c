// SPDX-License-Identifier: MIT
#pragma once

// What the answers to all questions are made of.

#include "explain.h"

#include <rastertrace/trace/record/replay.h>
#include <rastertrace/trace/record/traced_steps.h>

#include <cstddef>
#include <initializer_list>
#include <optional>
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

/// True of a primitive that clipping has made of the one of that name: ABC/1 of ABC.
bool is_part_of(const PrimitiveStep& primitive, std::string_view whole);

/// Throws a Problem: nothing that can be asked about has this name, and what there is.
[[noreturn]] void refuse_name(const Trace& trace, Topic topic, const std::string& name);

/// The triangles that a face was cut into, or the one primitive that it is. A name that no face has is thrown as a
/// Problem.
std::vector<std::string> triangles_of_face(const Trace& trace, const std::string& name);

/// What the trace does not have of what an answer rests on, a sentence each: steps of these kinds, those beyond its
/// region (of a pixel in it, nothing), those of other primitives, what came after its end.
std::vector<std::string> what_lacks(const Trace& trace, std::initializer_list<StepKind> kinds,
                                    std::optional<Pixel> pixel = {});

/// Why steps of a primitive may be missing, so that nothing follows from one that is not there; "" if all are
/// there. `is_last`: the trace ends in it.
std::string why_steps_may_lack(const Trace& trace, bool is_last);

/// Answers by topic. A name that is not there is thrown as a Problem.
Explanation explain_pixel(const Trace& trace, const Question& question);
Explanation explain_scanline(const Trace& trace, int y);
Explanation explain_face(const Trace& trace, const std::string& name);
Explanation explain_vertex(const Trace& trace, const std::string& name);
Explanation explain_edge(const Trace& trace, const std::string& name);
Explanation explain_pair(const Trace& trace, const std::string& names);

} // namespace rastertrace
