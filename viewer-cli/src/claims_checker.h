// SPDX-License-Identifier: MIT
#pragma once

// Checks files of claims, one after the other.
//
//     ClaimsChecker checker({});
//     checker.hold_against(scene);       // or each file names its scene, or its exercise
//     checker.check(sheet).checked.wrong;

#include "check_report.h"
#include "load.h"

#include <rastertrace/trace/check/check.h>
#include <rastertrace/trace/exercise/exercise.h>

#include <optional>
#include <string>

namespace rastertrace {

class ClaimsChecker {
public:
    explicit ClaimsChecker(SceneOptions options) : options_(std::move(options)) {}

    /// All claims are about this scene or trace, whatever scene they name. Throws a Problem.
    void hold_against(Source source) { given_.emplace(truth_in(std::move(source), options_)); }

    /// All claims are about exercises like this scene, which they name. Throws a Problem.
    void hold_against_exercises_like(const Source& scene) { exercises_.emplace(scene); }

    /// What the claims were held against is damaged, or sound.
    ExitStatus report() const { return given_ ? report_damage(given_->decided()) : exit_fine; }

    /// The ID of the exercise that a sheet is about; empty if it is about no exercise. Throws a Problem if it should
    /// have one.
    std::string exercise_of(const Source& sheet) const;

    /// Throws a Problem if the file is none of claims, or its scene cannot be drawn.
    CheckedFile check(Source source);

private:
    const Truth& truth_for(const Claims& claims);

    SceneOptions options_;
    std::optional<Truth> given_;
    std::optional<ExerciseMaker> exercises_;
    std::string last_name_;     ///< of the scene, or the ID of the exercise, that came last
    std::string last_sheet_;    ///< of the exercise, empty
    std::optional<Truth> last_; ///< about it
};

} // namespace rastertrace
