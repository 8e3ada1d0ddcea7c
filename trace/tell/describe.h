// SPDX-License-Identifier: MIT
#pragma once

// What a step says, in the words and formulas of the textbook, with the numbers put in:
//
//     scanline y=2   left AB: x = 2 + 3/4 (2 - 5) = -1/4 -> -1   right AC: x = 2 - 3/8 (2 - 5) =
//     25/8 -> 3

#include <rastertrace/trace/record/replay.h>
#include <rastertrace/trace/record/step_kind.h>

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace rastertrace {

/// True if the rule of a depth test, step n, lets larger depths pass: by `depth_compare`, by a test of two
/// different depths, or by the kind of depth. nullopt if none of them tells: `ndc-z` of equal depths.
std::optional<bool> larger_depth_passes(const Trace& trace, std::size_t n);

/// The current step of a replay in one line, safe to print.
std::string describe_step(const Replay& replay);

/// The same as its kind of step has it (step_kind.h), and what stands for each of its placeholders, safe to print.
struct Sentence {
    std::string_view
        pattern; ///< "at ({x}, {y}): d = {d} ..."; of a step that we do not know "{step}"
    std::vector<std::string> fills;
};
Sentence sentence_of_step(const Replay& replay);

/// The parts of a pattern between its placeholders, one more than there are of these.
std::vector<std::string_view> pieces_of(std::string_view pattern);

/// The first placeholder of a pattern that nothing can stand for in steps of this kind, such as one that is misspelt;
/// "" if each of them is known.
std::string_view unknown_placeholder(std::string_view pattern, const StepRow& row);

} // namespace rastertrace
