// SPDX-License-Identifier: MIT
#pragma once

// The names of the stages of drawing, as scenes, traces and options say them.
//
//     stage_named("depth");  // Stage::depth

#include <rastertrace/core/draw/scene/stage.h>

#include <optional>
#include <string_view>
#include <vector>

namespace rastertrace {

/// model, view, ...
std::string_view name_of(Stage stage);

/// The stage of that name, if there is one.
std::optional<Stage> stage_named(std::string_view name);

/// All names, in the order in which the stages run.
std::vector<std::string_view> stage_names();

} // namespace rastertrace
