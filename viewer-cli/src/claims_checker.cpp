// SPDX-License-Identifier: MIT
#include "claims_checker.h"

namespace rastertrace {

std::string ClaimsChecker::exercise_of(const Source& sheet) const {
    return exercises_ ? value_or_throw(exercise_of_sheet(sheet)) : "";
}

CheckedFile ClaimsChecker::check(Source source) {
    CheckedFile file{.name = source.name};
    file.claims = value_or_throw(read_claims(std::move(source)));
    if (file.claims.claims.empty())
        throw problem_of(file.name, "expected claims, found none",
                         "rastertrace sheet SCENE writes a sheet to fill in");
    file.checked = rastertrace::check(truth_for(file.claims), file.claims);
    return file;
}

const Truth& ClaimsChecker::truth_for(const Claims& claims) {
    if (given_)
        return *given_;
    const std::string exercise = exercise_of(claims.source);
    const std::string name = exercises_ ? exercise : path_of_scene(claims);
    if (last_ && name == last_name_)
        return *last_;
    last_.reset();
    Source scene = exercises_ ? exercises_->exercise(exercise).scene
                              : load_scene_of_claims(name, options_.limits);
    last_name_ = name;
    return last_.emplace(truth_in(std::move(scene), options_));
}

} // namespace rastertrace
