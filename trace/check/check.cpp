// SPDX-License-Identifier: MIT
#include "check.h"

#include "claim_comparison.h"
#include "claim_forms.h"
#include "claim_meaning.h"
#include "claim_subject.h"
#include "drawn_mistakes.h"
#include "picture_claim.h"
#include "wrong_explainer.h"

#include <rastertrace/core/numbers/number.h>
#include <rastertrace/trace/explain/explain.h>
#include <rastertrace/trace/record/traced_steps.h>
#include <rastertrace/trace/tell/describe.h>
#include <rastertrace/trace/tell/step_text.h>
#include <rastertrace/trace/tell/working.h>
#include <rastertrace/trace/text/text.h>

#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <deque>
#include <map>
#include <optional>
#include <string_view>
#include <utility>

namespace rastertrace {

namespace {

/// A number with many digits, as a hand writes it: 3.16227766, and 1/3 as 0.3333333333.
std::string in_ten_digits(const std::string& value) {
    const auto number = number_in(value);
    if (!number || number->get_den() < 1'000'000)
        return value;
    return abs(*number) <= root_tolerance(*number)
               ? "0"
               : fmt::format("{:.10g}", nearest_double(*number));
}

/// True if what a decision is made by lies so near its limit that many digits of roots do not tell on which side.
bool is_at_tie(const Formula& formula) {
    const auto is_zero = [](const Rational& number) {
        return abs(number) <= root_tolerance(number);
    };
    const auto is_end_at_tie = [](RoundedEnd end) {
        const Rational error = root_tolerance(end.x);
        end.x -= error;
        const Rational before = end.by(end.rule);
        end.x += 2 * error;
        return before != end.by(end.rule);
    };
    if (const auto* const end = std::get_if<RoundedEnd>(&formula.of))
        return is_end_at_tie(*end);
    if (const auto* const row = std::get_if<InRow>(&formula.of))
        return is_end_at_tie(row->from) || is_end_at_tie(row->to);
    if (const auto* const face = std::get_if<IsCulled>(&formula.of))
        return is_zero(face->dot);
    const auto* const test = std::get_if<DepthComparison>(&formula.of);
    return test != nullptr && is_zero(test->depth - test->stored);
}

/// Checks the claims of one file.
class Checker {
public:
    Checker(const Truth& truth, const Claims& claims) : truth_(truth.index()), claims_(claims) {}

    Checked run() {
        compare_claims();
        DrawnMistakes mistakes(truth_, claims_);
        WrongExplainer explainer(wrong_, mistakes);
        for (std::size_t i = 0; i < claims_.claims.size(); ++i)
            if (subjects_[i])
                explainer.explain(*subjects_[i], i, checked_.claims[i]);
        explainer.rank_slips(subjects_, checked_);
        for (CheckedClaim& claim : checked_.claims)
            settle(claim);
        write_workings();
        return std::move(checked_);
    }

private:
    /// What was claimed of a number first.
    struct Said {
        std::vector<std::optional<Rational>> values; ///< nothing of what is open
        std::size_t line;
        bool is_right;

        /// True if both have the same place with different numbers.
        bool contradicts(const Said& other) const {
            for (std::size_t i = 0; i < std::min(values.size(), other.values.size()); ++i)
                if (values[i] && other.values[i] && values[i] != other.values[i])
                    return true;
            return false;
        }
    };

    static std::vector<std::optional<Rational>> values_said(const ClaimedField& field,
                                                            const Values& values) {
        std::vector<std::optional<Rational>> said(values.begin(), values.end());
        for (std::size_t i = 0; i < said.size(); ++i)
            if (i >= field.values.size() || field.values[i] == open_value)
                said[i].reset();
        return said;
    }

    /// If no claim is understood, that is thrown as a Problem.
    void compare_claims() {
        for (std::size_t i = 0; i < claims_.claims.size(); ++i)
            try {
                if (claims_.claims[i].problem)
                    throw *claims_.claims[i].problem;
                compare_claim(i);
            } catch (Problem& problem) {
                if (problem.hint.empty() && claims_.is_table)
                    problem.hint = form_of(claims_.claims[i].step);
                subjects_.resize(i);
                subjects_.emplace_back();
                checked_.claims.push_back({.claim = i,
                                           .verdict = ClaimVerdict::not_understood,
                                           .problem = std::move(problem)});
                ++checked_.not_understood;
            }
        if (checked_.not_understood == claims_.claims.size() && checked_.not_understood > 0)
            throw *checked_.problem();
    }

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
        Claim& meant = meant_.emplace_back(as_meant(claim, claims_, truth_));
        subjects_.back() = subject_of(meant, claims_, truth_);
        const Subject& subject = *subjects_.back();
        CheckedClaim checked{.claim = i, .step = subject.step};
        if (subject.is_left_out)
            checked.remarks.push_back(
                said("steps were left out of the trace: it may be one of these"));
        else if (!subject.absence.empty())
            checked.remarks.push_back(subject.absence);
        name_snapped_place(meant, subject);
        take_empty_row(meant, subject);
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

    /// A row without pixels has a last pixel one before its first, whichever that is: 3..2 means 4..3, if that is told.
    void take_empty_row(Claim& meant, const Subject& subject) const {
        std::array<ClaimedField*, 2> ends{};
        for (ClaimedField& field : meant.fields)
            if (field.name == "from" || field.name == "to")
                ends[field.name == "to"] = &field;
        if (ends[0] == nullptr || ends[1] == nullptr)
            return;
        const ToldValues from = told_as_decided(subject, *ends[0]);
        const ToldValues to = told_as_decided(subject, *ends[1]);
        const auto pixels = [](const std::vector<std::string>& first,
                               const std::vector<std::string>& last) -> std::optional<Rational> {
            const auto a = first.empty() ? std::nullopt : typed_value(first.front());
            const auto b = last.empty() ? std::nullopt : typed_value(last.front());
            return a && b ? std::optional<Rational>(b->value - a->value + 1) : std::nullopt;
        };
        const auto told = from && to ? pixels(*from, *to) : std::nullopt;
        if (!told || *told > 0 || pixels(ends[0]->values, ends[1]->values) != Rational(0))
            return;
        ends[0]->values = *from;
        ends[1]->values = *to;
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
        const std::vector<std::string>* right = decided ? &*decided : &*exact;
        checked.expected = joined(*right, ", ");
        if (field.name == "angle" || field.name == "length")
            checked.expected = in_ten_digits(checked.expected);
        const bool is_vertex = subject.kind == StepKind::vertex;
        const NumbersHeld held = numbers_held(subject);
        Comparison comparison = compare(field, *right, held, is_vertex);
        if (decides && exact && decided != exact) {
            // A value that is still open is not given away.
            if (!has_open(field))
                checked.remark = said("the scene's `{}` has {}, exact arithmetic {}",
                                      truth_.decided().trace().method.word_of("scalar"),
                                      as_written(field, checked.expected),
                                      as_written(field, joined(*exact, ", ")));
            if (const Comparison other = compare(field, *exact, held, is_vertex);
                !comparison.is_right && other.is_right) {
                comparison = other;
                right = &*exact;
            }
        }
        const auto form = form_that_fits(subject, field, *right);
        if (form) {
            right = &form->values;
            comparison = compare(field, *right, held, is_vertex);
        }
        const bool has_root = !decides && exact &&
                              (!comparison.is_right || comparison.fit == Fit::truncated) &&
                              compare_with_many_digits(field, comparison, checked);
        if (decides && !has_open(field))
            note_tie(subject, field, checked);
        note_fit(comparison, has_root, checked);
        if (!comparison.is_right && field.name == "culled" && subject.decided_step == 0)
            claim.remarks.push_back(said("the scene culls nothing"));
        if (comparison.is_open) {
            checked.verdict = ClaimVerdict::open;
        } else if (is_by_place(field)) {
            mark_numbers(field, *right, held, checked);
            if (form && !form->name.empty())
                checked.remark += (checked.remark.empty() ? "" : "; ") + form->name;
        } else if (!comparison.is_right) {
            checked.verdict = ClaimVerdict::wrong;
            note_count(field, *right, checked);
        }
        note_number(field, *right, order, comparison.fit, checked, claim);
        return checked;
    }

    /// Sines and roots are doubles in what is drawn. What somebody worked out is held against more digits of them.
    /// False if there are none.
    bool compare_with_many_digits(const ClaimedField& field, Comparison& comparison,
                                  CheckedField& checked) {
        const Subject& subject = *subjects_.back();
        const auto other = with_many_digits(subject, truth_);
        ToldValues told = cosine_with_many_digits(other.value_or(subject), field);
        if (!told && other)
            told = told_exactly(*other, field);
        if (!told)
            return false;
        comparison =
            compare(field, *told, NumbersHeld::many_digits, subject.kind == StepKind::vertex);
        std::vector<std::string> digits;
        for (const std::string& value : *told)
            digits.push_back(in_ten_digits(value));
        checked.expected = joined(digits, ", ");
        return true;
    }

    /// A decision that the last bits of a root make: in exact numbers it is, or may be, a tie.
    void note_tie(const Subject& subject, const ClaimedField& field, CheckedField& checked) const {
        const auto other = with_many_digits(subject, truth_);
        if (!other || !checked.remark.empty())
            return;
        for (const Formula& formula : formulas_of(*other, other->exact->right(), field.name))
            if (is_at_tie(formula)) {
                checked.remark =
                    said("by the sines and roots as doubles; without rounding it is a tie");
                return;
            }
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

    /// Says how a decimal was shortened. One that was cut off is wrong only where that is asked for.
    void note_fit(Comparison& comparison, bool has_root, CheckedField& checked) const {
        if (!comparison.is_right)
            return;
        const std::string digits =
            said_count(static_cast<std::uint64_t>(comparison.places), "digit");
        if (comparison.fit == Fit::rounded)
            checked.remark = said("rounded to {}", digits);
        if (comparison.fit != Fit::truncated)
            return;
        checked.remark = said("cut off behind {}, not rounded", digits);
        // A root has to be shortened, one way or the other.
        comparison.is_right = !claims_.only_rounds || has_root;
    }

    /// The other form of a list that more of its numbers fit; nothing if none does.
    static std::optional<OtherForm> form_that_fits(const Subject& subject,
                                                   const ClaimedField& field,
                                                   const std::vector<std::string>& right) {
        const std::size_t width = numbers_in_place(subject, field);
        const auto fitting = [&](const std::vector<std::string>& values) {
            std::size_t count = 0;
            for (std::size_t i = 0; i + width <= std::min(values.size(), field.values.size());
                 i += width)
                count += std::equal(values.begin() + static_cast<std::ptrdiff_t>(i),
                                    values.begin() + static_cast<std::ptrdiff_t>(i + width),
                                    field.values.begin() + static_cast<std::ptrdiff_t>(i),
                                    [](const std::string& a, const std::string& b) {
                                        return normal_form(a) == normal_form(b);
                                    })
                             ? 1
                             : 0;
            return count;
        };
        std::optional<OtherForm> best;
        std::size_t most = fitting(right);
        for (OtherForm& form : other_forms(subject, field))
            if (const std::size_t count = fitting(form.values);
                count > most ||
                (best && count == most && form.values.size() == field.values.size())) {
                most = count;
                best = std::move(form);
            }
        return best;
    }

    /// Marks each number of a list by itself, or each pixel.
    void mark_numbers(const ClaimedField& field, const std::vector<std::string>& right,
                      NumbersHeld held, CheckedField& checked) const {
        const std::size_t width = numbers_in_place(*subjects_.back(), field);
        const std::size_t count = (field.values.size() + width - 1) / width;
        const std::size_t belong = right.size() / width;
        const auto at_place = [width](const std::vector<std::string>& values, std::size_t place) {
            const auto at = [&values](std::size_t i) {
                return values.begin() + static_cast<std::ptrdiff_t>(std::min(i, values.size()));
            };
            return std::vector<std::string>(at(width * place), at(width * (place + 1)));
        };
        bool was_right = true;
        for (std::size_t place = 0; place < count; ++place) {
            const auto found = at_place(field.values, place);
            const auto expected = at_place(right, place);
            const Comparison one = compare({.name = {}, .values = found}, expected, held, false);
            checked.claimed_numbers += one.is_open ? 0 : 1;
            checked.right_numbers += one.is_right && !one.is_open ? 1 : 0;
            if (!one.is_right) {
                const bool follows = !was_right && field.name != "rows" &&
                                     goes_on_from_last(field, right, width, place);
                checked.numbers.push_back(
                    {.place = place + 1,
                     .verdict = follows ? ClaimVerdict::follows : ClaimVerdict::wrong,
                     .expected = expected.empty() ? "none" : joined(expected, ", "),
                     .found = joined(found, ", ")});
            }
            was_right = one.is_right;
        }
        const bool goes_on = field.goes_on || field.values.back() == open_value;
        checked.ends_early = count < belong && !goes_on;
        if (!checked.numbers.empty()) {
            const CheckedNumber& first = checked.numbers.front();
            checked.verdict = ClaimVerdict::wrong;
            checked.place = first.place;
            checked.expected = first.expected;
            checked.found = first.found;
            const auto follow = std::count_if(
                checked.numbers.begin(), checked.numbers.end(),
                [](const CheckedNumber& one) { return one.verdict == ClaimVerdict::follows; });
            const std::size_t right_ones = checked.right_numbers;
            checked.remark =
                follow > 0
                    ? said("{} of {} right, {} follow", right_ones, checked.claimed_numbers, follow)
                    : said("{} of {} right", right_ones, checked.claimed_numbers);
            if (checked.ends_early)
                checked.remark += said("; ends early: {} belong", belong);
            else if (count > belong)
                checked.remark += said("; {} belong", belong);
        } else if (checked.ends_early) {
            checked.verdict = ClaimVerdict::open;
            checked.remark = said("ends early: the first {} of {}", count, belong);
        } else if (count < belong) {
            checked.remark = said("the first {} of {}", count, belong);
        }
    }

    /// True if the number at a place is the one before it and the right increment: that between the right ones, or what
    /// Bresenham's rule adds to the wrong one.
    bool goes_on_from_last(const ClaimedField& field, const std::vector<std::string>& right,
                           std::size_t width, std::size_t place) const {
        const auto difference = [](const std::vector<std::string>& values, std::size_t from,
                                   std::size_t to) -> std::optional<Rational> {
            const auto a = typed_value(values[from]);
            const auto b = to < values.size() ? typed_value(values[to]) : std::nullopt;
            return a && b ? std::optional<Rational>(b->value - a->value) : std::nullopt;
        };
        bool is_right_increment = true;
        for (std::size_t i = width * place; i < width * (place + 1); ++i) {
            const auto claimed = difference(field.values, i - width, i);
            is_right_increment = is_right_increment && claimed && i < right.size() &&
                                 claimed == difference(right, i - width, i);
        }
        const auto formulas =
            formulas_of(*subjects_.back(), subjects_.back()->exact->right(), field.name);
        const auto* const line =
            formulas.empty() ? nullptr : std::get_if<BresenhamDecisions>(&formulas.front().of);
        const auto before = typed_value(field.values[place - 1]);
        const auto after = typed_value(field.values[place]);
        return is_right_increment || (line != nullptr && before && after && place < right.size() &&
                                      line->next(before->value) == after->value);
    }

    /// A place of a list of a primitive's pixels has x and y.
    static std::size_t numbers_in_place(const Subject& subject, const ClaimedField& field) {
        return subject.kind == StepKind::primitive && field.name == "pixels" ? 2 : 1;
    }

    /// Says that a list has too few numbers, or too many.
    void note_count(const ClaimedField& field, const std::vector<std::string>& right,
                    CheckedField& checked) const {
        const std::size_t width = numbers_in_place(*subjects_.back(), field);
        const std::size_t count = field.values.size() / width;
        const std::size_t belong = right.size() / width;
        // A vertex may be given without a z of 0.
        const bool lacks_z =
            field.name == "at" && count == 2 && right.size() == 3 && right[2] == "0";
        if (field.is_list && count != belong && !lacks_z)
            checked.remark =
                belong == 1
                    ? said("{}, where 1 belongs", said_count(count, "value##counted"))
                    : said("{}, where {} belong", said_count(count, "value##counted"), belong);
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
        const Said here{values_said(field, values), line, is_right};
        const auto [place, is_new] = claimed_.try_emplace(name, here);
        const Said& first = place->second;
        const std::string remark = said("contradicts line {}", first.line);
        // Two roundings of one number are no contradiction.
        if (!is_new && first.contradicts(here) && first.line != line &&
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

    /// What a claim's fields make of it.
    void settle(CheckedClaim& claim) {
        if (claim.verdict == ClaimVerdict::not_understood)
            return;
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
        const bool ends_early = std::any_of(claim.fields.begin(), claim.fields.end(),
                                            [](const auto& field) { return field.ends_early; });
        checked_.end_early += claim.verdict == ClaimVerdict::open && ends_early ? 1 : 0;
        ++(claim.verdict == ClaimVerdict::right     ? checked_.right
           : claim.verdict == ClaimVerdict::wrong   ? checked_.wrong
           : claim.verdict == ClaimVerdict::follows ? checked_.follow
                                                    : checked_.open);
    }

    /// What is told of the tries to write a pixel, and of the primitives that have not.
    static constexpr std::size_t most_told = 3;

    const std::optional<Explanation>& told_of_pixel(const Subject& subject) {
        const Pixel pixel = pixel_of(subject);
        const auto [known, is_new] = told_of_pixels_.try_emplace({pixel.x, pixel.y});
        if (is_new)
            if (auto told = explain(truth_.decided().trace(), {.pixel = pixel}))
                known->second = std::move(told.value());
        return known->second;
    }

    /// What became of a pixel, and the last tries to write it. Empty if only one was made.
    std::vector<std::string> tries_at_pixel(const Subject& subject) {
        const auto& told = told_of_pixel(subject);
        if (!told)
            return {};
        const auto are_several = [&](StepKind kind) {
            return std::count_if(told->tries.begin(), told->tries.end(), [&](const Try& one) {
                       return truth_.decided().trace().kind_of(one.number) == kind;
                   }) > 1;
        };
        if (!are_several(StepKind::pixel) && !are_several(StepKind::depth))
            return {};
        std::vector<std::string> lines{told->answer};
        const std::size_t first = told->tries.size() - std::min(told->tries.size(), most_told);
        // The claim's own step is told with its working.
        for (std::size_t i = first; i < told->tries.size(); ++i)
            if (told->tries[i].number != subject.decided_step)
                lines.push_back(told->tries[i].sentence);
        return lines;
    }

    /// Why a pixel is drawn or not, as `explain` says it: by the claim's own step, or the last that tried, and by the
    /// primitive that is named, or those that came nearest.
    std::vector<std::string> why_pixel(const Subject& subject) {
        const auto& told = told_of_pixel(subject);
        if (!told)
            return {};
        std::vector<std::string> lines{told->answer};
        auto shown = std::find_if(told->tries.begin(), told->tries.end(), [&](const Try& one) {
            return one.number == subject.decided_step;
        });
        if (shown == told->tries.end() && !told->tries.empty())
            --shown;
        if (shown != told->tries.end())
            lines.insert(lines.end(), shown->working.begin(), shown->working.end());
        const auto* const in =
            std::find_if(subject.keys.data(), subject.keys.data() + subject.keys.size(),
                         [](const auto& key) { return key.first == "in"; });
        const bool names_one = in != subject.keys.data() + subject.keys.size();
        std::vector<WhyNot> nearest = told->why_not;
        std::erase_if(nearest, [&](const WhyNot& why) {
            return why.sentence.empty() || (names_one && why.primitive != in->second);
        });
        if (nearest.size() > most_told) {
            std::stable_sort(nearest.begin(), nearest.end(), was_nearer_to_drawing);
            nearest.resize(most_told);
        }
        for (const WhyNot& why : nearest) {
            lines.push_back(why.sentence);
            lines.insert(lines.end(), why.working.begin(), why.working.end());
        }
        return lines;
    }

    /// The step that shows how a place of a list is worked out; 0 for that of the list.
    static std::size_t step_of_place(const Subject& subject, const CheckedField& wrong) {
        if (wrong.place == 0)
            return 0;
        // d is worked out from the one before it.
        const bool are_pixels = subject.kind == StepKind::primitive;
        const auto steps = are_pixels ? pixels_of(subject.exact->steps(), subject.step)
                           : subject.kind == StepKind::decide
                               ? decisions_from(*subject.exact, subject.step)
                               : std::vector<std::size_t>{};
        const std::size_t place = are_pixels ? wrong.place : wrong.place - 1;
        return 0 < place && place <= steps.size() ? steps[place - 1] : 0;
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
            if (subjects_[i]->is_off_canvas)
                continue;
            const bool is_of_pixel = subjects_[i]->kind == StepKind::pixel;
            if (is_of_pixel && is_decision(StepKind::pixel, wrong->name) &&
                wrong->name != "color") {
                claim.working = why_pixel(*subjects_[i]);
                continue;
            }
            if (is_of_pixel)
                claim.working = tries_at_pixel(*subjects_[i]);
            std::size_t step = step_of(*subjects_[i], wrong->name);
            if (const std::size_t at_place = step_of_place(*subjects_[i], *wrong); at_place != 0)
                step = at_place;
            if (step != 0)
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
                claim->working.insert(claim->working.end(), working.begin(), working.end());
        }
    }

    const TruthIndex& truth_;
    const Claims& claims_;
    Checked checked_;
    std::vector<std::optional<Subject>> subjects_; ///< of each claim; none of a picture
    std::deque<Claim> meant_;                      ///< those that the subjects' fields belong to
    std::map<std::string, Said> claimed_;          ///< first, by number
    WrongNumbers wrong_;
    std::map<std::pair<int, int>, std::optional<Explanation>> told_of_pixels_; ///< by x and y
};

} // namespace

Checked check(const Truth& truth, const Claims& claims) {
    Checked checked = Checker(truth, claims).run();
    if (checked.wrong > 0)
        for (const auto& [ties, other] : truth.with_other_ties())
            if (Checked by_other = Checker(other, claims).run();
                by_other.wrong + by_other.follow == 0) {
                by_other.remark = said("right with `ties: {}`", ties);
                return by_other;
            }
    return checked;
}

std::optional<Problem> Checked::problem() const {
    std::vector<Problem> problems;
    for (const CheckedClaim& claim : claims)
        if (claim.problem)
            problems.push_back(*claim.problem);
    return problems.empty() ? std::nullopt : std::optional(first_of(std::move(problems)));
}

std::string place_in_list(std::size_t place, std::string_view field) {
    return place == 0        ? ""
           : field == "rows" ? said(", row {}, column {}", (place - 1) / 4 + 1, (place - 1) % 4 + 1)
                             : said(", number {}", place);
}

std::string difference_text(const Claims& claims, const CheckedField& field,
                            std::string_view expected, std::string_view found, std::size_t place) {
    if (field.name == "picture")
        return fmt::format("{}: {}", words_for_field(field.name), found);
    const auto as_written = [&](std::string_view value) {
        const bool is_of_json = !claims.is_table && (value == "true" || value == "false");
        return is_of_json ? value : word_for_value(field.name, value);
    };
    return said("{}{}: expected {}, found {}", claims.in_words(field.name),
                place_in_list(place, field.name), as_written(expected), as_written(found));
}

} // namespace rastertrace
