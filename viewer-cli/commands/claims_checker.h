// SPDX-License-Identifier: MIT
#pragma once

// Checks files of claims, one after the other.
//
//     ClaimsChecker checker({}, [](const Problem& remark) { print_error(remark); });
//     checker.hold_against(scene);       // or each file names its scene
//     checker.check(sheet).checked.wrong;

#include "app/load.h"
#include "commands/check_report.h"

#include <rastertrace/trace/check/check.h>
#include <rastertrace/trace/check/exercise.h>

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

    /// All claims are about this scene or trace, whatever scene they name; those of a sheet that names its exercise are
    /// about the exercise like this scene. Throws a Problem.
    void hold_against(Source source);

    /// What the claims were held against is damaged, or sound.
    ExitStatus report() const { return given_ ? report_damage(given_->decided()) : exit_fine; }

    /// Throws a Problem if the file is none of claims, or its scene cannot be drawn.
    CheckedFile check(Source source);

private:
    const Truth& truth_for(const CheckedFile& file);
    Truth told_truth(Source source) const;

    SceneOptions options_;
    TellRemark tell_;
    std::optional<Truth> given_;
    std::optional<Source> given_scene_;
    std::string like_; ///< the scene of `make_exercise_`
    ExerciseMaker make_exercise_;
    std::string last_name_;     ///< of the scene that came last, and the ID of its exercise
    std::string last_sheet_;    ///< of the exercise, empty
    std::optional<Truth> last_; ///< about it
};

} // namespace rastertrace
