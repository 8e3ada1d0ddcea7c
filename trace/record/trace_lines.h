// SPDX-License-Identifier: MIT
#pragma once

// What is checked of a step, and of the end record. The reader is in trace_reader.cpp.

#include "step_kind.h"
#include "trace.h"
#include "traced_steps.h"

#include <rastertrace/core/raster/image.h>
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

/// That so many steps are whole, and then the file ends.
std::string truncation_after(std::size_t steps);

/// That there are not as many as the end record says: `expected 62 steps as the end record says, found 61`.
std::string disagreement(std::string_view told, std::string_view what, std::string_view found);

/// True if an end record says something about the picture.
bool tells_picture(const EndRecord& end);

/// What the picture that comes of all steps has otherwise than the end record says.
std::optional<std::string> disagreement_of_picture(const Trace& header, const EndRecord& end,
                                                   const Image& image);

} // namespace rastertrace
