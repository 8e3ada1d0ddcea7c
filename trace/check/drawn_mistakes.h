// SPDX-License-Identifier: MIT
#pragma once

// The known mistakes that programs make, behind wrong claims: the model draws the scene with each. One is named if its
// drawing has all that a claim says, and something else than is right of each wrong number.
//
//     DrawnMistakes mistakes(truth, claims);
//     mistakes.name_in(subject, claim);  // claim.fields[0].slips: equal-depth-passes

#include "check.h"
#include "claim_subject.h"

#include <map>
#include <optional>
#include <string_view>
#include <utility>
#include <vector>

namespace rastertrace {

/// Both must outlive it.
class DrawnMistakes {
public:
    DrawnMistakes(const TruthIndex& truth, const Claims& claims) : truth_(truth), claims_(claims) {}

    /// Names the mistakes behind the wrong fields of a claim, unless a slip of that name is.
    void name_in(const Subject& subject, CheckedClaim& claim);

    /// True if a field would say something else with a mistake.
    bool changes(std::string_view mistake, const Subject& subject, const ClaimedField& field);

private:
    const Subject* subject_with(const Mistake& mistake, const Subject& subject);
    /// `right`: what is told exactly of each field of the subject.
    bool accounts_for(const Mistake& mistake, const Subject& subject, const CheckedClaim& claim,
                      const std::vector<ToldValues>& right);

    const TruthIndex& truth_;
    const Claims& claims_;
    std::map<std::pair<const Mistake*, const Claim*>, std::optional<Subject>> subjects_;
};

} // namespace rastertrace
