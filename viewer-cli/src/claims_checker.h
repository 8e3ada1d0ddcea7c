// SPDX-License-Identifier: MIT
#pragma once

// Checks files of claims, one after the other.
//
//     ClaimsChecker checker({}, [](const Problem& remark) { print_error(remark); });
//     checker.hold_against(scene);       // or each file names its scene, or its exercise
//     checker.check(sheet).checked.wrong;

#include "check_report.h"
#include "load.h"

#include <rastertrace/trace/check/check.h>
#include <rastertrace/trace/exercise/exercise.h>

#include <functional>
#include <optional>
#include <string>

namespace rastertrace {

using TellRemark = std::function<void(const Problem&)>;

class ClaimsChecker {
public:
    /// Remarks on the scenes that it draws go to `tell`.
    ClaimsChecker(SceneOptions options, TellRemark tell)
        : options_(std::move(options)), tell_(std::move(tell)) {}

    /// All claims are about this scene or trace, whatever scene they name. Throws a Problem.
    void hold_against(Source source) { given_.emplace(told_truth(std::move(source))); }

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
    Truth told_truth(Source source) const;

    SceneOptions options_;
    TellRemark tell_;
    std::optional<Truth> given_;
    std::optional<ExerciseMaker> exercises_;
    std::string last_name_;     ///< of the scene, or the ID of the exercise, that came last
    std::string last_sheet_;    ///< of the exercise, empty
    std::optional<Truth> last_; ///< about it
};

} // namespace rastertrace
