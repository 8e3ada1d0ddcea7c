// SPDX-License-Identifier: MIT
#pragma once

// The primitives of two traces, found by their names, and which of them have moved.
//
//     const auto in_b = find_by_name(of_a, of_b);  // in_b[0]: where the first one of a is in b
//     const auto stays = in_common_order(in_b);

#include <rastertrace/trace/record/step_lines.h>

#include <cstddef>
#include <string>
#include <vector>

namespace rastertrace {

/// A primitive, and where its steps begin and end.
struct PrimitivePlace {
    std::string name{};
    LinePlace begin{};
    LinePlace end{};
};

/// Stands for a place in the other list that there is not.
inline constexpr std::size_t nowhere = static_cast<std::size_t>(-1);

/// Where in b each one of a is: the second of a name is the second there.
std::vector<std::size_t> find_by_name(const std::vector<PrimitivePlace>& a,
                                      const std::vector<PrimitivePlace>& b);

/// Which of them come in the same order in both, as many as can: a longest increasing subsequence of the places
/// (Fredman, On computing the length of longest increasing subsequences, 1975). All others have moved.
std::vector<bool> in_common_order(const std::vector<std::size_t>& places);

} // namespace rastertrace
