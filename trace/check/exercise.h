// SPDX-License-Identifier: MIT
#pragma once

// Exercises: a scene with its vertices drawn anew, as much work as it was, in which every slip that can be made gives an
// answer of its own. The same ID gives the same exercise everywhere.
//
//     const ExerciseMaker exercise = exercises_like(scene);
//     exercise(exercise_id("anna").value()).text;  // {"canvas": ..., "vertices": {"A": [1, 6], ...

#include <rastertrace/trace/record/trace.h>
#include <rastertrace/trace/scene/distinguish.h>
#include <rastertrace/trace/text/problem.h>

#include <functional>
#include <map>
#include <string>
#include <string_view>

namespace rastertrace {

/// The ID of what was typed: `anna` is `1:anna`, of the first version of the generator. A Problem for one without letters,
/// of more than 100, that could not be read back from a sheet, or of a version that there is not.
Result<std::string> exercise_id(std::string_view typed);

/// The line of a sheet that names its exercise: "# exercise 1:anna\n".
std::string exercise_line(std::string_view id);

/// The ID that such a line of a sheet has, "" without one.
Result<std::string> exercise_of_sheet(const Source& sheet);

/// Makes the exercise with an ID. Numbers of one axis that were equal stay equal, and smaller ones stay smaller;
/// denominators are at most 8; vertices lie on the canvas, or, of a projected scene, within the box of the old ones; the
/// facts stay. Throws a Problem if no numbers are found with which each slip gives an answer of its own.
using ExerciseMaker = std::function<Source(std::string_view id)>;

/// Of exercises like a scene. Throws a Problem if it cannot be drawn, has no vertices of its own, or if no other numbers
/// have its facts.
ExerciseMaker exercises_like(const Source& scene);

/// What makes an exercise as hard as another, and how often it is there, of a trace in exact numbers: "ABC: rows" 8.
using ExerciseFacts = std::map<std::string, int>;
ExerciseFacts exercise_facts(const Trace& trace);

/// For each of slips(), all the numbers that it makes of what can be worked out in a trace, as text; none where it cannot
/// be made.
Answers slip_answers_in(const Trace& trace);

} // namespace rastertrace
