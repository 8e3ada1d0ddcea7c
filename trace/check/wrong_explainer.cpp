// SPDX-License-Identifier: MIT
#include "wrong_explainer.h"

#include "claim_comparison.h"
#include "typed_number.h"

#include <rastertrace/trace/tell/step_text.h>

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <utility>

namespace rastertrace {

namespace {

/// The formula that a field was worked out by; nothing if there is none. No slip is named by any other.
std::optional<Formula> formula_of(const Subject& subject, const ClaimedField& field) {
    auto formulas = formulas_of(subject, subject.exact->right(), field.name);
    const ToldValues told = told_exactly(subject, field);
    if (formulas.empty() || !told)
        return std::nullopt;
    const Values right = value_of(formulas.front());
    if (field.name == "color" && levels_in(told->front()) == right)
        return std::move(formulas.front());
    if (told->size() != right.size())
        return std::nullopt;
    for (std::size_t i = 0; i < right.size(); ++i) {
        const auto number = number_in((*told)[i]);
        if (number && !agrees(right[i], *number, subject.exact->trace()))
            return std::nullopt;
    }
    return std::move(formulas.front());
}

/// The formula of one number of Bresenham's d, or of one pixel of a line: the first, or from the one before it, as it is
/// claimed, which its values begin with.
std::optional<Formula> step_in_list(const Formula& formula, const ClaimedField& field,
                                    std::size_t place) {
    const auto claimed = [&field](std::size_t i) -> std::optional<Rational> {
        const auto typed = i < field.values.size() ? typed_value(field.values[i]) : std::nullopt;
        return typed ? std::optional(typed->value) : std::nullopt;
    };
    if (const auto* const line = std::get_if<BresenhamDecisions>(&formula.of)) {
        BresenhamDecisions step = *line;
        step.steps = std::min<std::size_t>(place, 2);
        if (place > 1)
            step.other_start = claimed(place - 2);
        return place > 1 && !step.other_start ? std::nullopt : std::optional(Formula{step});
    }
    const auto* const pixels = std::get_if<LinePixels>(&formula.of);
    if (pixels == nullptr || place < 2)
        return std::nullopt;
    const Values d = value_of({pixels->decisions});
    const auto x = claimed(2 * place - 4);
    const auto y = claimed(2 * place - 3);
    if (!x || !y || place - 2 >= d.size())
        return std::nullopt;
    LinePixels step = *pixels;
    step.decisions.steps = 1;
    step.decisions.other_start = d[place - 2];
    step.from = {*x, *y};
    return Formula{step};
}

bool share_slip(const std::vector<LikelySlip>& some, const std::vector<LikelySlip>& others) {
    return std::any_of(some.begin(), some.end(), [&others](const LikelySlip& one) {
        return std::any_of(others.begin(), others.end(),
                           [&one](const LikelySlip& other) { return other.name == one.name; });
    });
}

} // namespace

void WrongExplainer::explain(const Subject& subject, std::size_t order, CheckedClaim& claim) {
    explain_by_formulas(subject, order, claim);
    mistakes_.name_in(subject, claim);
}

void WrongExplainer::explain_by_formulas(const Subject& subject, std::size_t order,
                                         CheckedClaim& claim) {
    for (std::size_t k = 0; k < claim.fields.size() && k < subject.fields.size(); ++k) {
        CheckedField& checked = claim.fields[k];
        const ClaimedField& field = *subject.fields[k];
        if (checked.verdict != ClaimVerdict::wrong || follows(subject, field, order, checked))
            continue;
        if (const auto formula = formula_of(subject, field)) {
            checked.rule = rule_of(*formula).rule;
            checked.formula = rule_of(*formula).formula;
            checked.slips = slips_that_give(*formula, name_of_number(subject, field), field);
            if (checked.slips.empty())
                explain_numbers(*formula, name_of_number(subject, field), field, checked);
        }
    }
    if (subject.kind != StepKind::scanline)
        return;
    explain_exchanged_ends(subject, claim);
    const auto from = end_of(subject, claim, "from");
    const auto to = end_of(subject, claim, "to");
    if (from && to) {
        hold_against_other_end(subject, *from, *to);
        hold_against_other_end(subject, *to, *from);
    }
}

/// Each wrong number of a list by the step that gives it, which goes on from the number before it as it is claimed.
void WrongExplainer::explain_numbers(const Formula& formula, const std::string& name,
                                     const ClaimedField& field, CheckedField& checked) {
    for (const CheckedNumber& number : checked.numbers) {
        const auto step = step_in_list(formula, field, number.place);
        if (number.verdict != ClaimVerdict::wrong || !step)
            continue;
        ClaimedField claimed{.name = field.name, .values = {}, .is_list = true};
        const std::size_t width = value_of(*step).size() / (number.place == 1 ? 1 : 2);
        const std::size_t first = number.place == 1 ? 0 : width * (number.place - 2);
        for (std::size_t i = first; i < std::min(width * number.place, field.values.size()); ++i)
            claimed.values.push_back(field.values[i]);
        for (LikelySlip& slip :
             slips_that_give(*step, fmt::format("{} {}", name, number.place), claimed)) {
            slip.place = number.place;
            checked.slips.push_back(std::move(slip));
        }
    }
}

std::optional<WrongExplainer::ClaimedEnd>
WrongExplainer::end_of(const Subject& subject, CheckedClaim& claim, std::string_view name) {
    for (std::size_t k = 0; k < claim.fields.size() && k < subject.fields.size(); ++k)
        if (claim.fields[k].name == name)
            if (auto formula = formula_of(subject, *subject.fields[k]))
                return ClaimedEnd{&claim.fields[k], subject.fields[k], std::move(*formula)};
    return std::nullopt;
}

/// Both pixels of a row are rounded by one rule. What gives the wrong one, but not the other as it is claimed, is not
/// behind it; what also leaves the other right is so much likelier, as chance would have hit either.
void WrongExplainer::hold_against_other_end(const Subject& subject, const ClaimedEnd& wrong,
                                            const ClaimedEnd& other) {
    const bool other_is_right = other.checked->verdict == ClaimVerdict::right;
    if (wrong.checked->verdict != ClaimVerdict::wrong ||
        (!other_is_right && other.checked->verdict != ClaimVerdict::wrong))
        return;
    const auto results_of = [&](const ClaimedEnd& end, std::size_t slip) {
        return redone(name_of_number(subject, *end.field), end.formula)[slip];
    };
    for (std::size_t i = 0; i < slips().size(); ++i) {
        const auto of_other = results_of(other, i);
        if (results_of(wrong, i).size() != 1 || of_other.size() > 1)
            continue; // more than one thing may have been done
        const bool gives_other =
            of_other.empty() ? other_is_right : gives(of_other.front().values, *other.field);
        const double either_end = std::log(2.0);
        std::erase_if(wrong.checked->slips, [&](LikelySlip& slip) {
            const bool is_it = slip.name == slips()[i].name;
            slip.evidence += is_it && other_is_right ? either_end : 0;
            return is_it && !gives_other;
        });
    }
}

/// Who takes one end of a row for the other, perhaps because one of them is wrong and they were sorted, has in each
/// what comes of the other's formula.
void WrongExplainer::explain_exchanged_ends(const Subject& subject, CheckedClaim& claim) {
    const auto left = end_of(subject, claim, "left");
    const auto right = end_of(subject, claim, "right");
    const auto is_wrong = [](const std::optional<ClaimedEnd>& end) {
        return end && end->checked->verdict == ClaimVerdict::wrong;
    };
    if (!is_wrong(left) || !is_wrong(right))
        return;
    const auto is_other = [](const ClaimedEnd& end, const ClaimedEnd& other) {
        return gives(value_of(other.formula), *end.field);
    };
    const auto slips_of_other = [&](const ClaimedEnd& end, const ClaimedEnd& other) {
        return slips_that_give(other.formula, name_of_number(subject, *other.field), *end.field);
    };
    const bool left_is_right = is_other(*left, *right);
    const bool right_is_left = is_other(*right, *left);
    const bool are_exchanged = left_is_right && right_is_left;
    if (!are_exchanged && share_slip(left->checked->slips, right->checked->slips))
        return;
    Slips slips_of_left = left_is_right ? Slips{} : slips_of_other(*left, *right);
    Slips slips_of_right = right_is_left ? Slips{} : slips_of_other(*right, *left);
    const bool is_explained = are_exchanged || (left_is_right && !slips_of_right.empty()) ||
                              (right_is_left && !slips_of_left.empty()) ||
                              share_slip(slips_of_left, slips_of_right);
    if (!is_explained)
        return;
    claim.remarks.push_back(said("left and right are exchanged"));
    left->checked->slips = std::move(slips_of_left);
    right->checked->slips = std::move(slips_of_right);
}

/// True if redoing a formula from the numbers of other claims gives what is claimed: the textbook's formula from all of
/// them, any other from those claimed before.
bool WrongExplainer::follows(const Subject& subject, const ClaimedField& field, std::size_t order,
                             CheckedField& checked) {
    const Values right =
        subject.step == 0 ? Values{} : subject.exact->right().of(subject.step, field.name);
    const auto comes_to_it = [&](const Formula& formula) {
        const Values values = value_of(formula);
        return values != right && gives(values, field);
    };
    const auto is_from = [&](const WrongNumber* used, bool is_it) {
        if (used == nullptr || !is_it)
            return false;
        if (const WrongNumber* const alone = last_that_gives(subject, field, order))
            used = alone;
        checked.verdict = ClaimVerdict::follows;
        checked.follows_from = used->line;
        checked.follows_from_field = used->field;
        checked.follows_from_rounded = used->is_rounded;
        return true;
    };
    const Numbers& all = claimed_numbers(*subject.exact);
    all.take_used();
    const auto by_textbook = formulas_of(subject, all, field.name);
    if (is_from(all.take_used(), !by_textbook.empty() && comes_to_it(by_textbook.front())))
        return true;
    const Numbers before(subject.exact->right(), wrong_, order);
    const auto by_any = formulas_of(subject, before, field.name);
    return is_from(before.take_used(), std::any_of(by_any.begin(), by_any.end(), comes_to_it));
}

/// Of the wrong numbers that give a claim by themselves, the one that was claimed last before it; nullptr if none does.
const WrongNumber* WrongExplainer::last_that_gives(const Subject& subject,
                                                   const ClaimedField& field,
                                                   std::size_t order) const {
    const WrongNumber* last = nullptr;
    for (const auto& [name, number] : wrong_) {
        const bool is_own = number.order == order && number.field == field.name;
        if (number.order > order || is_own || (last != nullptr && number.order < last->order))
            continue;
        const WrongNumbers alone{{name, number}};
        const auto formulas =
            formulas_of(subject, Numbers(subject.exact->right(), alone), field.name);
        if (!formulas.empty() && gives(value_of(formulas.front()), field))
            last = &number;
    }
    return last;
}

/// The numbers of a trace with all wrong ones in place of the right ones.
const Numbers& WrongExplainer::claimed_numbers(const StepIndex& index) {
    return numbers_.try_emplace(&index, index.right(), wrong_).first->second;
}

/// What a formula comes to with each slip in it. Several claims may be about one number.
const std::vector<std::vector<SlipResult>>& WrongExplainer::redone(const std::string& number,
                                                                   const Formula& formula) {
    const auto [place, is_new] = redone_.try_emplace(number);
    if (is_new)
        for (const Slip& slip : slips())
            place->second.push_back(slip.redo(formula));
    return place->second;
}

WrongExplainer::Slips WrongExplainer::slips_that_give(const Formula& formula,
                                                      const std::string& number,
                                                      const ClaimedField& field) {
    Slips found;
    const Values right = value_of(formula);
    const auto& results = redone(number, formula);
    for (std::size_t i = 0; i < results.size(); ++i)
        if (const auto one =
                std::find_if(results[i].begin(), results[i].end(),
                             [&](const SlipResult& redone) { return gives(redone.values, field); });
            one != results[i].end())
            found.push_back({std::string(slips()[i].name), meaning_of(slips()[i], one->detail),
                             evidence_for(results[i], field, right)});
    return found;
}

/// Counts, of each slip, the right numbers of a claim that would be others with it.
void WrongExplainer::count_not_made(const Subject& subject, const CheckedClaim& claim,
                                    std::map<std::string, HowOften>& how_often) const {
    for (std::size_t k = 0; k < claim.fields.size() && k < subject.fields.size(); ++k) {
        if (claim.fields[k].verdict != ClaimVerdict::right)
            continue;
        const ClaimedField& field = *subject.fields[k];
        const auto formula = formula_of(subject, field);
        const bool is_number = typed_value(field.values.front()).has_value();
        for (auto& [name, often] : how_often) {
            const Slip* const slip = find_slip(name);
            if (slip == nullptr) {
                often.not_made += mistakes_.changes(name, subject, field) ? 1 : 0;
                continue;
            }
            const auto results = formula && is_number // a verdict is right by chance, too
                                     ? slip->redo(*formula)
                                     : std::vector<SlipResult>();
            if (!results.empty() &&
                std::none_of(results.begin(), results.end(),
                             [&](const auto& one) { return gives(one.values, field); }))
                ++often.not_made;
        }
    }
}

void WrongExplainer::rank_slips(std::span<const std::optional<Subject>> subjects,
                                Checked& checked) const {
    // One habit may be behind many wrong numbers.
    std::map<std::string, double> likelihood;
    std::map<std::string, HowOften> how_often;
    for (const CheckedClaim& claim : checked.claims)
        for (const CheckedField& field : claim.fields)
            for (const LikelySlip& slip : field.slips) {
                likelihood.try_emplace(slip.name, prior_of(slip.name)).first->second +=
                    slip.evidence;
                ++how_often[slip.name].made;
            }
    if (how_often.size() > 1)
        for (std::size_t i = 0; i < checked.claims.size(); ++i)
            if (subjects[i])
                count_not_made(*subjects[i], checked.claims[i], how_often);
    const auto score = [&](const std::string& slip) {
        return likelihood.at(slip) + habit_of(how_often.at(slip));
    };
    for (CheckedClaim& claim : checked.claims)
        for (CheckedField& field : claim.fields) {
            std::erase_if(field.slips, [&](const LikelySlip& slip) {
                return likelihood.at(slip.name) < prior_of_chance();
            });
            std::stable_sort(field.slips.begin(), field.slips.end(),
                             [&](const LikelySlip& a, const LikelySlip& b) {
                                 return score(a.name) > score(b.name);
                             });
            for (const LikelySlip& slip : field.slips)
                if (std::find(checked.slips.begin(), checked.slips.end(), slip.name) ==
                    checked.slips.end())
                    checked.slips.push_back(slip.name);
        }
    std::stable_sort(checked.slips.begin(), checked.slips.end(),
                     [&](const auto& a, const auto& b) { return score(a) > score(b); });
}

} // namespace rastertrace
