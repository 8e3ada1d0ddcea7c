// SPDX-License-Identifier: MIT
#pragma once

// Scenes that tell rules apart: what they draw of them differs.
//
//     const auto scene = scene_apart(*rule_named("rounding=floor"), *rule_named("truncate-for-floor"), {});

#include "rule.h"

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace rastertrace {

/// How many random scenes are tried, at most.
inline constexpr std::uint64_t most_seeds = 300;

/// True if one of so many random scenes is drawn differently by two rules.
bool are_told_apart(const Rule& a, const Rule& b, const MethodOverrides& method,
                    std::uint64_t seeds);

/// A small scene that two rules draw differently: at most three triangles, or two lines. `method` is what it says
/// beside. `nullopt` if none is found in so many random ones: they draw the same, as far as anybody knows.
std::optional<Source> scene_apart(const Rule& a, const Rule& b, const MethodOverrides& method,
                                  std::uint64_t seeds = most_seeds);

/// A few scenes that together tell as many of the known mistakes apart as a set of random ones does.
std::vector<Source> probe_scenes(std::size_t jobs);

} // namespace rastertrace
