// SPDX-License-Identifier: MIT
#include "claims_checker.h"

#include <rastertrace/trace/check/claims_template.h>
#include <rastertrace/trace/exercise/exercise_id.h>

#include <fmt/core.h>

#include <map>
#include <set>
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

/// Marks a sheet by the empty one: what it lacks is open; what nobody asked for, or asked for once, does not count.
void mark_by_sheet(const Truth& truth, const std::string& sheet, CheckedFile& file) {
    struct Said {
        ClaimVerdict verdict = ClaimVerdict::right;
        std::vector<std::size_t> claims{};
    };
    std::map<std::string, Said> said;
    for (std::size_t i = 0; i < file.checked.claims.size(); ++i)
        for (const auto& [number, verdict] : numbers_of(file.claims, file.checked.claims[i])) {
            Said& one = said[number];
            one.verdict = worse_of(one.verdict, verdict);
            one.claims.push_back(i);
        }
    const Claims asked = value_or_throw(read_claims({.name = file.name, .text = sheet}));
    Checked& counts = file.checked;
    counts.right = counts.wrong = counts.follow = counts.open = 0;
    for (const CheckedClaim& claim : rastertrace::check(truth, asked).claims) {
        Mark mark{.verdict = ClaimVerdict::right, .asked = asked.claims[claim.claim].text};
        std::set<std::size_t> claims;
        for (const auto& [number, verdict] : numbers_of(asked, claim)) {
            const auto found = said.find(number);
            mark.verdict = worse_of(mark.verdict, found == said.end() ? ClaimVerdict::open
                                                                      : found->second.verdict);
            if (found != said.end())
                claims.insert(found->second.claims.begin(), found->second.claims.end());
        }
        mark.claims.assign(claims.begin(), claims.end());
        ++(mark.verdict == ClaimVerdict::right     ? counts.right
           : mark.verdict == ClaimVerdict::wrong   ? counts.wrong
           : mark.verdict == ClaimVerdict::follows ? counts.follow
                                                   : counts.open);
        file.marks.push_back(std::move(mark));
    }
}

} // namespace

std::string ClaimsChecker::exercise_of(const Source& sheet) const {
    return exercises_ ? value_or_throw(exercise_of_sheet(sheet)) : "";
}

CheckedFile ClaimsChecker::check(Source source) {
    CheckedFile file{.name = source.name};
    file.claims = value_or_throw(read_claims(std::move(source)));
    if (file.claims.claims.empty())
        throw problem_of(file.name, "expected claims, found none",
                         "rastertrace sheet SCENE writes a sheet to fill in");
    const Truth& truth = truth_for(file.claims);
    file.checked = rastertrace::check(truth, file.claims);
    if (exercises_) {
        mark_by_sheet(truth, last_sheet_, file);
        file.exercise = last_name_;
    } else {
        for (std::size_t i = 0; i < file.checked.claims.size(); ++i)
            file.marks.push_back({.claims = {i}, .verdict = file.checked.claims[i].verdict});
    }
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
                              : load_scene_of_claims(claims, options_.limits);
    last_name_ = name;
    if (exercises_) {
        const auto planned =
            value_or_throw(read_scene(scene, options_.method, options_.limits, options_.frames));
        last_sheet_ = claims_template(
            drawn_trace(planned.scene, planned.plan, scene.name, options_.limits.steps));
    }
    return last_.emplace(told_truth(std::move(scene)));
}

Truth ClaimsChecker::told_truth(Source source) const {
    Truth truth = truth_in(std::move(source), options_);
    for (const Problem& remark : truth.remarks())
        tell_(remark);
    return truth;
}

} // namespace rastertrace
