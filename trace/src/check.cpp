// SPDX-License-Identifier: MIT
#include <rastertrace/trace/check.h>

#include "claim_comparison.h"
#include "claim_subject.h"
#include "derivation.h"
#include "picture_claim.h"
#include "step_text.h"

#include <rastertrace/trace/describe.h>
#include <rastertrace/trace/slips.h>
#include <rastertrace/trace/text.h>
#include <rastertrace/trace/working.h>

#include <fmt/core.h>

#include <algorithm>
#include <map>
#include <memory>
#include <optional>
#include <string_view>
#include <utility>

namespace rastertrace {

namespace {

/// Checks the claims of one file.
class Checker {
public:
    Checker(const Truth& truth, const Claims& claims) : truth_(truth.index()), claims_(claims) {}

    Checked run() {
        for (std::size_t i = 0; i < claims_.claims.size(); ++i)
            compare_claim(i);
        for (std::size_t i = 0; i < claims_.claims.size(); ++i)
            explain_claim(i);
        rank_slips();
        for (CheckedClaim& claim : checked_.claims)
            settle(claim);
        write_workings();
        return std::move(checked_);
    }

private:
    using Slips = std::vector<LikelySlip>;

    /// What was claimed of a number first.
    struct Said {
        Values values;
        std::size_t line;
        bool is_right;
    };

    /// Compares each field with what is told.
    void compare_claim(std::size_t i) {
        const Claim& claim = claims_.claims[i];
        subjects_.emplace_back();
        if (claim.step == "picture") {
            if (truth_.decided().trace().is_partial)
                throw problem_at(claims_.source, claim.offset,
                                 "expected a trace with all pixels, found one that steps were left "
                                 "out of");
            checked_.claims.push_back(check_picture(claim, claims_, truth_.decided()));
            checked_.claims.back().claim = i;
            return;
        }
        subjects_.back() = subject_of(as_meant(claim), claims_, truth_);
        const Subject& subject = *subjects_.back();
        CheckedClaim checked{.claim = i, .step = subject.step};
        if (subject.is_left_out)
            checked.remarks.push_back("steps were left out of the trace: it may be one of these");
        else if (!subject.absence.empty())
            checked.remarks.push_back(subject.absence);
        snap_if_whole(*subjects_.back());
        for (const ClaimedField* field : subject.fields)
            checked.fields.push_back(compare_field(*field, i, checked));
        // A claim without values says that there is such a step.
        if (subject.fields.empty() && subject.step == 0)
            checked.fields.push_back({.name = claim.step,
                                      .verdict = ClaimVerdict::wrong,
                                      .expected = "none",
                                      .found = "one"});
        checked_.claims.push_back(std::move(checked));
    }

    /// `ABC: ?` is Bresenham's d of a line, and the verdict of a face: what ABC is tells which.
    const Claim& as_meant(const Claim& claim) {
        const ClaimedField* const d = claim.find("d");
        const ClaimedField* const name = claim.find("in");
        if (claim.step != name_of(StepKind::decide) || d == nullptr || !d->is_list ||
            d->values != std::vector<std::string>{std::string(open_value)} || name == nullptr ||
            !names_face(name->values.front(), truth_))
            return claim;
        meant_.push_back(std::make_unique<Claim>(claim));
        Claim& verdict = *meant_.back();
        verdict.step = name_of(StepKind::face);
        for (ClaimedField& field : verdict.fields) {
            field.name = field.name == "in" ? "name" : "culled";
            field.is_list = false;
        }
        return verdict;
    }

    /// Where a vertex is snapped, whole numbers are its pixel.
    void snap_if_whole(Subject& subject) {
        const bool names_pixel =
            std::any_of(subject.fields.begin(), subject.fields.end(),
                        [](const ClaimedField* field) { return field->name == "snapped"; });
        if (subject.kind != StepKind::vertex || subject.step == 0 || names_pixel ||
            !subject.exact->trace().step(subject.step).field("snapped"))
            return;
        for (const ClaimedField*& field : subject.fields) {
            const auto is_whole = [](const std::string& value) {
                return value.find_first_of("./") == std::string::npos;
            };
            if (field->name == "at" &&
                std::all_of(field->values.begin(), field->values.end(), is_whole)) {
                snapped_.push_back(std::make_unique<ClaimedField>(*field));
                snapped_.back()->name = "snapped";
                field = snapped_.back().get();
            }
        }
    }

    CheckedField compare_field(const ClaimedField& field, std::size_t order, CheckedClaim& claim) {
        const Subject& subject = *subjects_.back();
        CheckedField checked{.name = field.name, .found = joined(field.values, ", ")};
        const ToldValues exact = told_exactly(subject, field);
        const bool decides = is_decision(subject.kind, field.name);
        const ToldValues decided = decides ? told_as_decided(subject, field) : exact;
        if (!decided && !exact) {
            refuse_untold(field, subject);
            checked.expected = "none";
            checked.verdict = subject.is_left_out ? ClaimVerdict::open : ClaimVerdict::wrong;
            return checked;
        }
        const std::vector<std::string>& right = decided ? *decided : *exact;
        checked.expected = joined(right, ", ");
        const bool is_vertex = subject.kind == StepKind::vertex;
        const NumbersHeld held = numbers_held(subject, field);
        Comparison comparison = compare(field, right, held, is_vertex);
        if (decides && exact && decided != exact) {
            // A value that is still open is not given away.
            if (!has_open(field))
                checked.remark = fmt::format("the scene's `{}` has {}, exact arithmetic {}",
                                             truth_.decided().trace().method_value("scalar"),
                                             as_written(field, checked.expected),
                                             as_written(field, joined(*exact, ", ")));
            if (!comparison.is_right)
                comparison = compare(field, *exact, held, is_vertex);
        }
        note_fit(comparison, checked);
        if (!comparison.is_right && !comparison.is_open)
            note_count(field, right, checked);
        if (!comparison.is_right && field.name == "culled" && subject.decided_step == 0)
            claim.remarks.push_back("the scene culls nothing");
        if (comparison.is_open)
            checked.verdict = ClaimVerdict::open;
        else if (!comparison.is_right)
            checked.verdict = ClaimVerdict::wrong;
        note_number(field, right, order, comparison.fit, checked, claim);
        return checked;
    }

    /// A value as the claims would have it.
    std::string as_written(const ClaimedField& field, const std::string& value) const {
        return claims_.is_table ? std::string(word_for_value(field.name, value)) : value;
    }

    static bool has_open(const ClaimedField& field) {
        return std::find(field.values.begin(), field.values.end(), open_value) !=
               field.values.end();
    }

    /// A field that nothing is told of: the scene does not have it, or there is no such step.
    void refuse_untold(const ClaimedField& field, const Subject& subject) const {
        if (!subject.absence.empty())
            return;
        const bool is_depth = field.name == "z" || field.name == "inverse_z";
        if (is_depth && subject.exact->find(StepKind::depth, {}).empty())
            throw problem_at(claims_.source, field.offset,
                             "expected a scene with a depth buffer, found one without",
                             "--depth inverse-z gives it one");
        if (subject.kind != StepKind::pixel)
            throw problem_at(claims_.source, field.offset,
                             fmt::format("expected a field that the step `{}` has, found {}",
                                         name_of(subject.kind), field.name));
    }

    /// Says how a decimal was shortened. One that was cut off is right only where that is asked for.
    void note_fit(Comparison& comparison, CheckedField& checked) const {
        if (!comparison.is_right)
            return;
        const std::string digits =
            fmt::format("{} {}", comparison.places, comparison.places == 1 ? "digit" : "digits");
        if (comparison.fit == Fit::rounded)
            checked.remark = fmt::format("rounded to {}", digits);
        if (comparison.fit != Fit::truncated)
            return;
        checked.remark = fmt::format("cut off behind {}, not rounded", digits);
        comparison.is_right = claims_.truncates;
    }

    /// Says that a list has too few numbers, or too many.
    static void note_count(const ClaimedField& field, const std::vector<std::string>& right,
                           CheckedField& checked) {
        const std::size_t count = field.values.size();
        // A vertex may be given without a z of 0.
        const bool lacks_z =
            field.name == "at" && count == 2 && right.size() == 3 && right[2] == "0";
        if (field.is_list && count != right.size() && !lacks_z)
            checked.remark =
                fmt::format("{} {}, where {} belong{}", count, count == 1 ? "value" : "values",
                            right.size(), right.size() == 1 ? "s" : "");
    }

    /// Remembers what is claimed of a number, and tells if somebody claims two things of one.
    void note_number(const ClaimedField& field, const std::vector<std::string>& right,
                     std::size_t order, Fit fit, CheckedField& checked, CheckedClaim& claim) {
        const Subject& subject = *subjects_.back();
        const std::string name = name_of_number(subject, field);
        const Values values = claimed_values(field, right);
        if (values.empty() || checked.verdict == ClaimVerdict::open)
            return;
        const std::size_t line = claims_.claims[order].line;
        const bool is_right = checked.verdict == ClaimVerdict::right;
        const auto [place, is_new] = claimed_.try_emplace(name, Said{values, line, is_right});
        const Said& first = place->second;
        const std::string remark = fmt::format("contradicts line {}", first.line);
        // Two roundings of one number are no contradiction.
        if (!is_new && first.values != values && first.line != line &&
            !(first.is_right && is_right) &&
            std::find(claim.remarks.begin(), claim.remarks.end(), remark) == claim.remarks.end())
            claim.remarks.push_back(remark);
        // Who has rounded a number goes on from what is written.
        if (checked.verdict == ClaimVerdict::wrong || values != true_values(right))
            wrong_.try_emplace(
                name, WrongNumber{values, order, line, field.name, is_right && fit != Fit::exact});
    }

    /// What is told, as claimed_values has it.
    static Values true_values(const std::vector<std::string>& told) {
        return claimed_values({.name = {}, .values = told}, told);
    }

    /// Finds what a wrong field goes on from, or the slip behind it.
    void explain_claim(std::size_t i) {
        if (!subjects_[i])
            return;
        const Subject& subject = *subjects_[i];
        CheckedClaim& claim = checked_.claims[i];
        for (std::size_t k = 0; k < claim.fields.size() && k < subject.fields.size(); ++k) {
            CheckedField& checked = claim.fields[k];
            const ClaimedField& field = *subject.fields[k];
            if (checked.verdict != ClaimVerdict::wrong)
                continue;
            if (follows(subject, field, i, checked))
                continue;
            const auto formulas = formulas_of(subject, Numbers(*subject.exact), field.name);
            if (!formulas.empty() && gives_what_is_told(formulas.front(), subject, field))
                checked.slips =
                    slips_that_give(formulas.front(), name_of_number(subject, field), field);
        }
        explain_exchanged_ends(subject, claim);
    }

    /// An end of a row that is wrong, and its formula.
    struct WrongEnd {
        CheckedField* checked = nullptr;
        const ClaimedField* field = nullptr;
        Formula formula = {};
    };

    std::optional<WrongEnd> wrong_end(const Subject& subject, CheckedClaim& claim,
                                      std::string_view name) {
        for (std::size_t k = 0; k < claim.fields.size() && k < subject.fields.size(); ++k) {
            if (claim.fields[k].name != name || claim.fields[k].verdict != ClaimVerdict::wrong)
                continue;
            auto formulas = formulas_of(subject, Numbers(*subject.exact), name);
            if (!formulas.empty() &&
                gives_what_is_told(formulas.front(), subject, *subject.fields[k]))
                return WrongEnd{&claim.fields[k], subject.fields[k], std::move(formulas.front())};
        }
        return std::nullopt;
    }

    /// Who takes one end of a row for the other, perhaps because one of them is wrong and they were sorted, has in
    /// each what comes of the other's formula.
    void explain_exchanged_ends(const Subject& subject, CheckedClaim& claim) {
        if (subject.kind != StepKind::scanline)
            return;
        const auto left = wrong_end(subject, claim, "left");
        const auto right = wrong_end(subject, claim, "right");
        if (!left || !right)
            return;
        const auto is_other = [](const WrongEnd& end, const WrongEnd& other) {
            return gives(value_of(other.formula), *end.field);
        };
        const auto slips_of_other = [&](const WrongEnd& end, const WrongEnd& other) {
            return slips_that_give(other.formula, name_of_number(subject, *other.field),
                                   *end.field);
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
        claim.remarks.emplace_back("left and right are exchanged");
        left->checked->slips = std::move(slips_of_left);
        right->checked->slips = std::move(slips_of_right);
    }

    static bool share_slip(const Slips& some, const Slips& others) {
        return std::any_of(some.begin(), some.end(), [&others](const LikelySlip& one) {
            return std::any_of(others.begin(), others.end(),
                               [&one](const LikelySlip& other) { return other.name == one.name; });
        });
    }

    /// True if redoing a formula from the numbers of other claims gives what is claimed: the textbook's formula
    /// from all of them, any other from those claimed before.
    bool follows(const Subject& subject, const ClaimedField& field, std::size_t order,
                 CheckedField& checked) {
        const Values right =
            subject.step == 0 ? Values{} : subject.exact->numbers(subject.step, field.name);
        const auto comes_to_it = [&](const Formula& formula) {
            const Values values = value_of(formula);
            return values != right && gives(values, field);
        };
        const auto is_from = [&](const WrongNumber* used, bool is_it) {
            if (used == nullptr || !is_it)
                return false;
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
        const Numbers before(*subject.exact, wrong_, order);
        const auto by_any = formulas_of(subject, before, field.name);
        return is_from(before.take_used(), std::any_of(by_any.begin(), by_any.end(), comes_to_it));
    }

    /// The numbers of a trace with all wrong ones in place of the right ones.
    const Numbers& claimed_numbers(const StepIndex& index) {
        return numbers_.try_emplace(&index, index, wrong_).first->second;
    }

    /// True if a formula is the one that the number was worked out by: no slip is named by any other.
    static bool gives_what_is_told(const Formula& formula, const Subject& subject,
                                   const ClaimedField& field) {
        const ToldValues told = told_exactly(subject, field);
        const Values right = value_of(formula);
        if (!told || told->size() != right.size())
            return false;
        for (std::size_t i = 0; i < right.size(); ++i) {
            const auto number = number_in((*told)[i]);
            if (number && !agrees(right[i], *number, subject.exact->trace()))
                return false;
        }
        return true;
    }

    /// What a formula comes to with each slip in it. Several claims may be about one number.
    const std::vector<std::vector<Values>>& redone(const std::string& number,
                                                   const Formula& formula) {
        const auto [place, is_new] = redone_.try_emplace(number);
        if (is_new)
            for (const Slip& slip : slips())
                place->second.push_back(slip.redo(formula));
        return place->second;
    }

    Slips slips_that_give(const Formula& formula, const std::string& number,
                          const ClaimedField& field) {
        Slips found;
        const auto& results = redone(number, formula);
        for (std::size_t i = 0; i < results.size(); ++i)
            if (std::any_of(results[i].begin(), results[i].end(),
                            [&](const Values& values) { return gives(values, field); }))
                found.push_back({std::string(slips()[i].name), std::string(slips()[i].meaning)});
        return found;
    }

    /// Puts first what explains most of the wrong fields.
    void rank_slips() {
        std::map<std::string, std::size_t> explains;
        for (const CheckedClaim& claim : checked_.claims)
            for (const CheckedField& field : claim.fields)
                for (const LikelySlip& slip : field.slips)
                    ++explains[slip.name];
        for (CheckedClaim& claim : checked_.claims)
            for (CheckedField& field : claim.fields)
                std::stable_sort(field.slips.begin(), field.slips.end(),
                                 [&](const LikelySlip& a, const LikelySlip& b) {
                                     return explains.at(a.name) > explains.at(b.name);
                                 });
    }

    /// What a claim's fields make of it.
    void settle(CheckedClaim& claim) {
        const auto has = [&claim](ClaimVerdict verdict) {
            return std::any_of(claim.fields.begin(), claim.fields.end(),
                               [&](const auto& field) { return field.verdict == verdict; });
        };
        const bool is_open =
            std::all_of(claim.fields.begin(), claim.fields.end(),
                        [](const auto& field) { return field.verdict == ClaimVerdict::open; });
        claim.verdict = has(ClaimVerdict::wrong)           ? ClaimVerdict::wrong
                        : has(ClaimVerdict::follows)       ? ClaimVerdict::follows
                        : is_open && !claim.fields.empty() ? ClaimVerdict::open
                                                           : ClaimVerdict::right;
        ++(claim.verdict == ClaimVerdict::right     ? checked_.right
           : claim.verdict == ClaimVerdict::wrong   ? checked_.wrong
           : claim.verdict == ClaimVerdict::follows ? checked_.follow
                                                    : checked_.open);
    }

    /// The working of each wrong claim's step. A replay goes forward once.
    void write_workings() {
        std::map<std::pair<const StepIndex*, std::size_t>, std::vector<CheckedClaim*>> by_step;
        for (std::size_t i = 0; i < checked_.claims.size(); ++i) {
            CheckedClaim& claim = checked_.claims[i];
            if (claim.verdict != ClaimVerdict::wrong || !subjects_[i])
                continue;
            const auto wrong =
                std::find_if(claim.fields.begin(), claim.fields.end(), [](const auto& field) {
                    return field.verdict == ClaimVerdict::wrong;
                });
            if (const std::size_t step = step_of(*subjects_[i], wrong->name); step != 0)
                by_step[{subjects_[i]->exact, step}].push_back(&claim);
        }
        std::optional<Replay> replay;
        for (const auto& [place, claims] : by_step) {
            const auto& [index, step] = place;
            if (!replay || &replay->trace() != &index->trace())
                replay.emplace(index->trace(), FrameParts{.depths = true});
            replay->go_to(step);
            std::vector<std::string> working{describe_step(*replay)};
            for (std::string& line : working_of(*replay))
                working.push_back(std::move(line));
            for (CheckedClaim* claim : claims)
                claim->working = working;
        }
    }

    const TruthIndex& truth_;
    const Claims& claims_;
    Checked checked_;
    std::vector<std::optional<Subject>> subjects_; ///< of each claim; none of a picture
    std::vector<std::unique_ptr<ClaimedField>> snapped_;
    std::vector<std::unique_ptr<Claim>>
        meant_;                           ///< claims that are about something else than was read
    std::map<std::string, Said> claimed_; ///< first, by number
    WrongNumbers wrong_;
    std::map<const StepIndex*, Numbers> numbers_; ///< once all wrong ones are known
    std::map<std::string, std::vector<std::vector<Values>>> redone_; ///< by number, for each slip
};

} // namespace

Checked check(const Truth& truth, const Claims& claims) {
    return Checker(truth, claims).run();
}

} // namespace rastertrace
