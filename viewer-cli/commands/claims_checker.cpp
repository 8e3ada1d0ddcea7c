// SPDX-License-Identifier: MIT
#include "commands/claims_checker.h"

#include <rastertrace/trace/check/claims_template.h>
#include <rastertrace/trace/text/trace_layout.h>

#include <fmt/core.h>

#include <map>
#include <utility>
#include <vector>

namespace rastertrace {

namespace {

/// What a claim is about: each field of its step, or the picture.
std::vector<std::pair<std::string, ClaimVerdict>> numbers_of(const Claims& claims,
                                                             const CheckedClaim& claim) {
    if (claims.claims[claim.claim].step == "picture")
        return {{"picture", claim.verdict}};
    std::vector<std::pair<std::string, ClaimVerdict>> numbers;
    for (const CheckedField& field : claim.fields)
        numbers.emplace_back(fmt::format("{} {}", claim.step, field.name), field.verdict);
    return numbers;
}

/// Right, unless something in it is not.
ClaimVerdict worse_of(ClaimVerdict a, ClaimVerdict b) {
    for (const ClaimVerdict worst :
         {ClaimVerdict::wrong, ClaimVerdict::open, ClaimVerdict::follows})
        if (a == worst || b == worst)
            return worst;
    return ClaimVerdict::right;
}

/// Counts the lines of the empty sheet: what a sheet lacks is open; what nobody asked for, or asked for once, does not
/// count.
void count_by_empty_sheet(const Truth& truth, const std::string& sheet, CheckedFile& file) {
    std::map<std::string, ClaimVerdict> said;
    for (const CheckedClaim& claim : file.checked.claims)
        for (const auto& [number, verdict] : numbers_of(file.claims, claim)) {
            ClaimVerdict& known = said.try_emplace(number, verdict).first->second;
            known = worse_of(known, verdict);
        }
    const Claims asked = value_or_throw(read_claims({.name = file.name, .text = sheet}));
    Checked& counts = file.checked;
    counts.right = counts.wrong = counts.follow = counts.open = 0;
    for (const CheckedClaim& claim : rastertrace::check(truth, asked).claims) {
        ClaimVerdict verdict = ClaimVerdict::right;
        for (const auto& [number, open] : numbers_of(asked, claim)) {
            const auto found = said.find(number);
            verdict = worse_of(verdict, found == said.end() ? ClaimVerdict::open : found->second);
        }
        ++(verdict == ClaimVerdict::right     ? counts.right
           : verdict == ClaimVerdict::wrong   ? counts.wrong
           : verdict == ClaimVerdict::follows ? counts.follow
                                              : counts.open);
    }
}

} // namespace

void ClaimsChecker::hold_against(Source source) {
    if (!is_trace(source))
        given_scene_ = source;
    given_.emplace(told_truth(std::move(source)));
}

CheckedFile ClaimsChecker::check(Source source) {
    CheckedFile file{.name = source.name};
    if (!given_ || given_scene_)
        file.exercise = value_or_throw(exercise_of_sheet(source));
    file.claims = value_or_throw(read_claims(std::move(source)));
    if (file.claims.claims.empty())
        throw problem_of(file.name, "expected claims, found none",
                         "rastertrace sheet SCENE writes a sheet to fill in");
    const Truth& truth = truth_for(file);
    file.checked = rastertrace::check(truth, file.claims);
    if (!file.exercise.empty())
        count_by_empty_sheet(truth, last_sheet_, file);
    return file;
}

const Truth& ClaimsChecker::truth_for(const CheckedFile& file) {
    if (given_ && file.exercise.empty())
        return *given_;
    const std::string scene = given_ ? given_scene_->name : path_of_scene(file.claims);
    const std::string name = file.exercise + "\n" + scene;
    if (last_ && name == last_name_)
        return *last_;
    last_.reset();
    const auto load = [&] {
        return given_ ? *given_scene_ : load_scene_of_claims(file.claims, options_.limits);
    };
    if (file.exercise.empty()) {
        last_.emplace(told_truth(load()));
    } else {
        if (!make_exercise_ || like_ != scene)
            make_exercise_ = exercises_like(load());
        like_ = scene;
        Source exercise = make_exercise_(file.exercise);
        const auto planned =
            value_or_throw(read_scene(exercise, options_.method, options_.limits, options_.frames));
        last_sheet_ = claims_template(
            drawn_trace(planned.scene, planned.plan, exercise.name, options_.limits.steps));
        last_.emplace(told_truth(std::move(exercise)));
    }
    last_name_ = name;
    return *last_;
}

Truth ClaimsChecker::told_truth(Source source) const {
    Truth truth = truth_in(std::move(source), options_);
    for (const Problem& remark : truth.remarks())
        tell_(remark);
    return truth;
}

} // namespace rastertrace
