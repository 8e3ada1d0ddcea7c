// SPDX-License-Identifier: MIT
#include "drawn_mistakes.h"

#include "claim_comparison.h"
#include "slip_likelihood.h"
#include "slips.h"

#include <rastertrace/core/draw/model/mistakes.h>
#include <rastertrace/trace/tell/step_text.h>

#include <algorithm>
#include <cstddef>

namespace rastertrace {

namespace {

/// What is told, as numbers: a verdict as 1 or 0, a color as its levels.
Values values_in(const std::vector<std::string>& told) {
    if (told.size() == 1)
        if (Values levels = levels_in(told.front()); !levels.empty())
            return levels;
    Values values = claimed_values({.name = {}, .values = told}, told);
    return values.empty() ? Values{0} : values; // a word
}

} // namespace

/// The same claim about the drawing with a mistake; nullptr if that has no such step.
const Subject* DrawnMistakes::subject_with(const Mistake& mistake, const Subject& subject) {
    const TruthIndex* const drawn = truth_.drawn_with(mistake);
    if (drawn == nullptr)
        return nullptr;
    const auto [place, is_new] = subjects_.try_emplace({&mistake, subject.claim});
    if (is_new)
        try {
            place->second = subject_of(*subject.claim, claims_, *drawn);
        } catch (const Problem&) {
            return nullptr; // more than one step may be meant, or none
        }
    return place->second && place->second->step != 0 ? &*place->second : nullptr;
}

bool DrawnMistakes::accounts_for(const Mistake& mistake, const Subject& subject,
                                 const CheckedClaim& claim, const std::vector<ToldValues>& right) {
    const Subject* const other = subject_with(mistake, subject);
    if (other == nullptr)
        return false;
    for (std::size_t k = 0; k < claim.fields.size() && k < subject.fields.size(); ++k) {
        if (claim.fields[k].verdict == ClaimVerdict::open)
            continue;
        const ClaimedField& field = *subject.fields[k];
        const ToldValues told = told_exactly(*other, field);
        if (!told)
            return false;
        const Comparison comparison =
            compare(field, *told, NumbersHeld::fractions, subject.kind == StepKind::vertex);
        const bool is_wrong = claim.fields[k].verdict == ClaimVerdict::wrong;
        if (!comparison.is_right || comparison.fit == Fit::truncated ||
            (is_wrong && told == right[k]))
            return false;
    }
    return true;
}

void DrawnMistakes::name_in(const Subject& subject, CheckedClaim& claim) {
    const auto is_wrong = [](const CheckedField& field) {
        return field.verdict == ClaimVerdict::wrong;
    };
    if (std::none_of(claim.fields.begin(), claim.fields.end(), is_wrong))
        return;
    std::vector<ToldValues> right;
    for (const ClaimedField* const field : subject.fields)
        right.push_back(told_exactly(subject, *field));
    for (const Mistake& mistake : mistakes()) {
        if (!accounts_for(mistake, subject, claim, right))
            continue;
        for (std::size_t k = 0; k < claim.fields.size() && k < subject.fields.size(); ++k) {
            CheckedField& checked = claim.fields[k];
            const bool is_known = std::any_of(
                checked.slips.begin(), checked.slips.end(),
                [&mistake](const LikelySlip& slip) { return slip.name == mistake.name; });
            if (!is_wrong(checked) || is_known)
                continue;
            const ClaimedField& field = *subject.fields[k];
            const ToldValues with = told_exactly(*subject_with(mistake, subject), field);
            const double evidence =
                right[k] ? evidence_for({{values_in(*with)}}, field, values_in(*right[k])) : 0;
            checked.slips.push_back({std::string(mistake.name), meaning_of(mistake.name),
                                     evidence + prior_of_mistake() - prior_of(mistake.name)});
        }
    }
}

bool DrawnMistakes::changes(std::string_view mistake, const Subject& subject,
                            const ClaimedField& field) {
    const Mistake* const known = find_mistake(mistake);
    const Subject* const other = known == nullptr ? nullptr : subject_with(*known, subject);
    return other != nullptr && told_exactly(*other, field) != told_exactly(subject, field);
}

} // namespace rastertrace
