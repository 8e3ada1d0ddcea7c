// SPDX-License-Identifier: MIT
#pragma once

// Which primitives of two traces are the same, and which of them have moved. Names need not agree: another program may
// number its triangles, or call all of them alike.
//
//     const PrimitivePairs pairs = pair_primitives(of_a, of_b);  // pairs.in_b[0]: where the first one of a is in b
//     const auto stays = in_common_order(pairs.in_b);

#include <rastertrace/trace/record/traced_steps.h>

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

namespace rastertrace {

/// A primitive, and where its steps begin and end. Coordinates are rounded to 1/1024, so that those of a float and of a
/// fraction are the same.
struct PrimitivePlace {
    std::string name{};
    std::vector<std::uint64_t> corners{}; ///< a hash of the coordinates of each; none if not told
    std::uint64_t content = 0;            ///< a hash of its other steps
    std::size_t begin = 0;                ///< its first step
    std::size_t end = 0;                  ///< the one behind its last
};

/// The primitive that a step begins.
PrimitivePlace primitive_place(const PrimitiveStep& step, std::size_t begin);

/// True if two steps begin the same primitive: of one kind and name, with vertices of the same names, each within 0.001
/// (of its size, if that is larger) of the other.
bool begin_same_primitive(const PrimitiveStep& a, const PrimitiveStep& b);

/// Stands for a place in the other list that there is not.
inline constexpr std::size_t nowhere = static_cast<std::size_t>(-1);

/// Where in b each one of a is, and where in a each one of b.
struct PrimitivePairs {
    std::vector<std::size_t> in_b;
    std::vector<std::size_t> in_a;
};

/// Looked for, one after the other, are: the same name and corners; the same corners; a
/// name that each list has left once; then, between two that have been found, those that have most in common (corners,
/// steps or the name), in order; at last what is left of a name, in order.
PrimitivePairs pair_primitives(const std::vector<PrimitivePlace>& a,
                               const std::vector<PrimitivePlace>& b);

/// Which of them come in the same order in both, as many as can: a longest increasing subsequence of the places
/// (Fredman, On computing the length of longest increasing subsequences, 1975). All others have moved.
std::vector<bool> in_common_order(const std::vector<std::size_t>& places);

} // namespace rastertrace
