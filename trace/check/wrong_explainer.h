// SPDX-License-Identifier: MIT
#pragma once

// Why a claim is wrong: it goes on from another wrong number, or a slip in the formula gives what was claimed.
//
//     WrongExplainer explainer(wrong);
//     explainer.explain(subject, order, claim);  // claim.fields[0].slips: dx-dy-inverted
//     explainer.rank_slips(subjects, checked);

#include "check.h"
#include "claim_subject.h"
#include "drawn_mistakes.h"
#include "slip_likelihood.h"
#include "slips.h"

#include <rastertrace/trace/tell/formula.h>
#include <rastertrace/trace/tell/numbers.h>

#include <cstddef>
#include <map>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace rastertrace {

/// Explains the wrong claims of one file. The wrong numbers, all of them, and the mistakes must outlive it.
class WrongExplainer {
public:
    WrongExplainer(const WrongNumbers& wrong, DrawnMistakes& mistakes)
        : wrong_(wrong), mistakes_(mistakes) {}

    /// Finds what each wrong field of a claim goes on from, or the slips behind it. `order` is the claim's, as in the
    /// wrong numbers.
    void explain(const Subject& subject, std::size_t order, CheckedClaim& claim);

    /// Sorts each field's slips by how likely they are behind all that they explain, and leaves out what chance
    /// explains as well; puts all of them into checked.slips. There is a subject for each claim, or nothing.
    void rank_slips(std::span<const std::optional<Subject>> subjects, Checked& checked) const;

private:
    using Slips = std::vector<LikelySlip>;

    /// What is claimed of an end of a row, and its formula.
    struct ClaimedEnd {
        CheckedField* checked = nullptr;
        const ClaimedField* field = nullptr;
        Formula formula = {};
    };

    void explain_by_formulas(const Subject& subject, std::size_t order, CheckedClaim& claim);
    void explain_numbers(const Formula& formula, const std::string& name, const ClaimedField& field,
                         CheckedField& checked);
    const WrongNumber* last_that_gives(const Subject& subject, const ClaimedField& field,
                                       std::size_t order) const;
    void explain_exchanged_ends(const Subject& subject, CheckedClaim& claim);
    void hold_against_other_end(const Subject& subject, const ClaimedEnd& wrong,
                                const ClaimedEnd& other);
    static std::optional<ClaimedEnd> end_of(const Subject& subject, CheckedClaim& claim,
                                            std::string_view name);
    bool follows(const Subject& subject, const ClaimedField& field, std::size_t order,
                 CheckedField& checked);
    const Numbers& claimed_numbers(const StepIndex& index);
    const std::vector<std::vector<SlipResult>>& redone(const std::string& number,
                                                       const Formula& formula);
    Slips slips_that_give(const Formula& formula, const std::string& number,
                          const ClaimedField& field);

    void count_not_made(const Subject& subject, const CheckedClaim& claim,
                        std::map<std::string, HowOften>& how_often) const;

    const WrongNumbers& wrong_;
    DrawnMistakes& mistakes_;
    std::map<const StepIndex*, Numbers> numbers_; ///< with the wrong ones
    std::map<std::string, std::vector<std::vector<SlipResult>>>
        redone_; ///< by number, for each slip
};

} // namespace rastertrace
