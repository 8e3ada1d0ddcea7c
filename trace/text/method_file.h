// SPDX-License-Identifier: MIT
#pragma once

// The choices of a method as JSON has them: in a scene, and in a file of its own, which a course or a team shares.
//
//     {"fill": "top-left", "sample": "center", "depth": "linear-z"}

#include "input.h"
#include "json_reader.h"
#include "method_names.h"

#include <string>

namespace rastertrace {

/// The value of a key of the method: a word, a number or an array, as `key.set` takes it. Throws a Problem that points
/// at a value that it does not take.
std::string choice_in(const JsonReader& json, const MethodKey& key, const JsonValue& value);

/// The choices of such a file. Throws a Problem.
MethodOverrides method_in(const Source& file);

/// Reads a file whose keys are those of a scene's "method", and "convention". Throws a Problem.
MethodOverrides read_method_file(const std::string& path, const InputLimits& limits);

} // namespace rastertrace
