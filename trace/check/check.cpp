// SPDX-License-Identifier: MIT
#include "check.h"

#include "claim_comparison.h"
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

    /// What is wrong with the claims of a file is thrown as one Problem.
    void compare_claims() {
        std::vector<Problem> problems;
        for (std::size_t i = 0; i < claims_.claims.size(); ++i)
            try {
                compare_claim(i);
            } catch (Problem& problem) {
                problems.push_back(std::move(problem));
            }
        if (!problems.empty())
            throw first_of(std::move(problems));
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
        const std::vector<std::string>& right = decided ? *decided : *exact;
        checked.expected = joined(right, ", ");
        const bool is_vertex = subject.kind == StepKind::vertex;
        const NumbersHeld held = numbers_held(subject);
        Comparison comparison = compare(field, right, held, is_vertex);
        if (decides && exact && decided != exact) {
            // A value that is still open is not given away.
            if (!has_open(field))
                checked.remark = said("the scene's `{}` has {}, exact arithmetic {}",
                                      truth_.decided().trace().method.word_of("scalar"),
                                      as_written(field, checked.expected),
                                      as_written(field, joined(*exact, ", ")));
            if (!comparison.is_right)
                comparison = compare(field, *exact, held, is_vertex);
        }
        const bool has_root = !decides && exact &&
                              (!comparison.is_right || comparison.fit == Fit::truncated) &&
                              compare_with_many_digits(field, comparison, checked);
        if (decides && !has_open(field))
            note_tie(subject, field, checked);
        note_fit(comparison, has_root, checked);
        if (is_by_place(field))
            note_place(field, right, held, checked);
        else if (!comparison.is_right && !comparison.is_open)
            note_count(field, right, checked);
        if (!comparison.is_right && field.name == "culled" && subject.decided_step == 0)
            claim.remarks.push_back(said("the scene culls nothing"));
        if (comparison.is_open)
            checked.verdict = ClaimVerdict::open;
        else if (!comparison.is_right)
            checked.verdict = ClaimVerdict::wrong;
        note_number(field, right, order, comparison.fit, checked, claim);
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

    /// Says how a decimal was shortened. One that was cut off is right only where that is asked for.
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
        comparison.is_right = claims_.truncates || has_root;
    }

    /// Says how much of a list is claimed, or which place is the first that is wrong.
    void note_place(const ClaimedField& field, const std::vector<std::string>& right,
                    NumbersHeld held, CheckedField& checked) const {
        const std::size_t count = field.values.size();
        const std::size_t width = numbers_in_place(*subjects_.back(), field);
        std::size_t first_wrong = 0;
        while (first_wrong < count && first_wrong < right.size() &&
               is_right_at(field.values[first_wrong], right[first_wrong], held))
            ++first_wrong;
        if (first_wrong == count) {
            if (count < right.size())
                checked.remark = said("the first {} of {}", count / width, right.size() / width);
            return;
        }
        if (first_wrong == right.size()) {
            note_count(field, right, checked);
            return;
        }
        const std::size_t place = first_wrong / width;
        const auto at_place = [&](const std::vector<std::string>& values) {
            const auto begin = values.begin() + static_cast<std::ptrdiff_t>(width * place);
            const auto end = values.size() < width * (place + 1)
                                 ? values.end()
                                 : begin + static_cast<std::ptrdiff_t>(width);
            return joined(std::vector<std::string>(begin, end), ", ");
        };
        checked.place = place + 1;
        checked.expected = at_place(right);
        checked.found = at_place(field.values);
        checked.remark = what_follows(field, place);
    }

    /// A place of a list of a primitive's pixels has x and y.
    static std::size_t numbers_in_place(const Subject& subject, const ClaimedField& field) {
        return subject.kind == StepKind::primitive && field.name == "pixels" ? 2 : 1;
    }

    static bool is_right_at(const std::string& claimed, const std::string& told, NumbersHeld held) {
        return compare({.name = {}, .values = {claimed}}, {told}, held, false).is_right;
    }

    /// What is to be said of the places behind the first wrong one of Bresenham's d: whether each goes on from the one
    /// before it.
    std::string what_follows(const ClaimedField& field, std::size_t place) const {
        const auto formulas =
            formulas_of(*subjects_.back(), subjects_.back()->exact->right(), field.name);
        const auto* const line =
            formulas.empty() ? nullptr : std::get_if<BresenhamDecisions>(&formulas.front().of);
        for (std::size_t i = place + 1; line != nullptr && i < field.values.size(); ++i) {
            const auto before = typed_value(field.values[i - 1]);
            const auto after = typed_value(field.values[i]);
            if (before && after && line->next(before->value) != after->value)
                return said("number {} does not follow from the one before it", i + 1);
        }
        return place + 1 < field.values.size() && line != nullptr
                   ? said("what stands behind it follows from it")
                   : "";
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
    return Checker(truth, claims).run();
}

std::string place_in_list(const CheckedField& field) {
    return field.place == 0 ? "" : said(", number {}", field.place);
}

std::string difference_text(const Claims& claims, const CheckedField& field,
                            std::string_view expected, std::string_view found) {
    if (field.name == "picture")
        return fmt::format("{}: {}", words_for_field(field.name), found);
    const auto as_written = [&](std::string_view value) {
        const bool is_of_json = !claims.is_table && (value == "true" || value == "false");
        return is_of_json ? value : word_for_value(field.name, value);
    };
    return said("{}{}: expected {}, found {}", claims.in_words(field.name), place_in_list(field),
                as_written(expected), as_written(found));
}

} // namespace rastertrace
