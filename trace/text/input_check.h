// SPDX-License-Identifier: MIT
#pragma once

// Looks at a file while it is read, block by block, so that one that is too large, never ends or is
// no text is left alone as soon as that is known.

#include "input.h"
#include "problem.h"

#include <cstddef>
#include <optional>

namespace rastertrace {

/// The longest line of a trace, in bytes.
inline constexpr std::size_t longest_line = 16'000'000;

/// What is said of a longer one.
Problem line_too_long(const Source& source, std::size_t line_begin);

class InputCheck {
public:
    enum class Kind {
        scene_or_trace,        ///< JSON; a trace may have any size, but not each of its lines
        scene_trace_or_claims, ///< the same, or a table of claims
        bytes,                 ///< no text at all
        other,                 ///< any text
    };

    InputCheck(Kind kind, const InputLimits& limits) : kind_(kind), limits_(limits) {}

    /// What is wrong with a source of which the block from `block` on has just been added.
    std::optional<Problem> operator()(const Source& source, std::size_t block);

private:
    bool holds_trace(const Source& source);

    Kind kind_;
    InputLimits limits_;
    bool has_begun_ = false;       ///< the beginning has been looked at
    std::size_t line_begin_ = 0;   ///< of the last line so far
    std::optional<bool> is_trace_; ///< once somebody had to know
};

} // namespace rastertrace
