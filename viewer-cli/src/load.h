// SPDX-License-Identifier: MIT
#pragma once

// Inputs of commands: a scene, or a trace, or a scene where a trace is wanted, which is drawn
// first.

#include "commands.h"

#include <rastertrace/trace/problem.h>
#include <rastertrace/trace/scene_file.h>
#include <rastertrace/trace/trace.h>

#include <string>
#include <string_view>
#include <utility>

namespace rastertrace {

/// What was made, or the Problem that kept it from being made, thrown.
template <typename T> T value_or_throw(Result<T> result) {
    if (!result)
        throw result.problem();
    return std::move(result.value());
}

/// Reads and plans the scene in a file ("-" for standard input). Throws a Problem; that standard
/// output is one of the files that are read is one. Remarks go to standard error.
PlannedScene load_scene(const std::string& path, const MethodOverrides& method,
                        const InputLimits& limits = {});

/// The text of the scene in a file, not yet read. Throws a Problem; a trace is one.
Source load_scene_source(const std::string& path, const InputLimits& limits = {});

/// The title to show: the given one, or else the name of the file that has none, without its folder.
std::string shown_title(const std::string& title, const std::string& path);

/// Reads the trace in a file, or draws the scene in it, and gives it a title to show. Throws a
/// Problem. Damage that leaves the trace usable is left to the caller, see report_damage.
Trace load_trace(const std::string& path, const MethodOverrides& method,
                 const InputLimits& limits = {});

/// Reads the Markdown page in a file, which is no pipe and no device. Throws a Problem.
Source load_page(const std::string& path);

/// Tells on standard error what is wrong with a trace that can be used all the same. Returns the
/// exit status that this means: bad input if there was something to tell.
ExitStatus report_damage(const Trace& trace);

/// Writes to standard output. Throws a Problem.
void print(std::string_view text);

/// Writes to standard error, if it takes it: that it does not changes nothing else.
void print_error(std::string_view text) noexcept;

} // namespace rastertrace
