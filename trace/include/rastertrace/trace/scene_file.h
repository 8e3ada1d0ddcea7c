// SPDX-License-Identifier: MIT
#pragma once

// Scene files: JSON to Scene. docs/scene-format.md describes them.
//
//     const auto read = read_scene({"first.json", text});
//     draw(read.value().scene, read.value().plan, listener);

#include <rastertrace/core/draw/plan.h>
#include <rastertrace/core/scene/scene.h>
#include <rastertrace/trace/input.h>
#include <rastertrace/trace/method_names.h>
#include <rastertrace/trace/problem.h>

#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace rastertrace {

/// A scene, and how it is drawn.
struct PlannedScene {
    Scene scene;
    Plan plan;
    std::vector<FileId> files; ///< that it was read from: its own, and those of its meshes

    /// What can be drawn, but is probably not what its author meant.
    std::vector<Problem> remarks;
};

/// Reads a scene. `overrides` take the place of what its "method" says. The scene that comes back
/// can be drawn: every name is known, every number is finite, and no step can overflow. That is
/// found out by planning, so the plan comes with it. `limits` are for the files of its meshes.
Result<PlannedScene> read_scene(const Source& source, const MethodOverrides& overrides = {},
                                const InputLimits& limits = {});

/// What stands between names that are written as one: nothing if each is one letter, "-" otherwise.
std::string_view name_separator(std::span<const std::string_view> names);

/// Names written as one: "ABC", or "P1-P2-P3".
std::string joined_names(std::span<const std::string_view> names);

} // namespace rastertrace
