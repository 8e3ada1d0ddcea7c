// SPDX-License-Identifier: MIT
#pragma once

// Parts of the reader (trace_reader.cpp): what is checked of a step; a header and an end record alone.

#include "step_kind.h"
#include "trace.h"
#include "traced_steps.h"

#include <rastertrace/trace/text/problem.h>

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

namespace rastertrace {

/// The kind of the step that a part of a source holds, if we know it. Throws a Problem if it is no step that can be
/// understood.
std::optional<StepKind> checked_kind(const Source& source, std::size_t begin, std::size_t size);

/// Counts a step, if it has a quantity that is not finite.
void note_not_finite(NotFiniteSteps& noted, const Source& source, std::size_t begin,
                     std::string_view json, StepKind kind);

/// That there are not as many as the end record says: `expected 62 steps as the end record says, found 61`.
std::string disagreement(std::string_view told, std::string_view what, std::string_view found);

/// The header and the end record that write_trace has written, with no step between them.
Trace trace_around_steps(Source source);

} // namespace rastertrace
