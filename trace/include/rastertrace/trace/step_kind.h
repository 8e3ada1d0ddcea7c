// SPDX-License-Identifier: MIT
#pragma once

// The kinds of step that a trace file knows by name.

#include <cstddef>
#include <optional>
#include <string_view>
#include <vector>

namespace rastertrace {

/// In the order in which a picture meets them; the end record counts them in this order.
enum class StepKind {
    matrix,
    vertex,
    order,
    primitive,
    face,
    light,
    clip,
    edge,
    half,
    ray,
    scanline,
    along,
    decide,
    sample,
    depth,
    pixel,
    reject,
    skip,
    undecided,
};

inline constexpr std::size_t step_kinds = 19;

/// The value of "step": matrix, vertex, ...
std::string_view name_of(StepKind kind);

/// The kind of that name, if we know it. A trace may hold kinds that we do not know.
std::optional<StepKind> step_kind_named(std::string_view name);

/// All names.
std::vector<std::string_view> step_kind_names();

} // namespace rastertrace
