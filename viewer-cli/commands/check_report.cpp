// SPDX-License-Identifier: MIT
#include "commands/check_report.h"

#include <rastertrace/trace/check/slips.h>
#include <rastertrace/trace/tell/step_text.h>
#include <rastertrace/trace/tell/working.h>
#include <rastertrace/trace/text/language.h>
#include <rastertrace/trace/text/text.h>

#include <fmt/core.h>

#include <algorithm>
#include <cstddef>
#include <map>
#include <optional>
#include <set>
#include <utility>

namespace rastertrace {

namespace {

/// How many slips of a claim are named.
constexpr std::size_t most_slips = 3;

/// How much of a claim, or of a value that was claimed, is shown.
constexpr std::size_t shown_of_claim = 100;

/// How much of a right value is shown: four long fractions.
constexpr std::size_t shown_of_expected = 200;

std::string shown(std::string_view text) {
    return shortened(printable(text), shown_of_claim);
}

std::string shown_expected(std::string_view text) {
    return shortened(printable(as_in_working(text)), shown_of_expected);
}

/// "anna.txt:3: y=2: 0, 25/8"
std::string place_of(const CheckedFile& file, const CheckedClaim& claim) {
    return fmt::format("{}:{}: {}", printable(file.name), file.claim_of(claim).line,
                       shown(file.claim_of(claim).text));
}

Words words_of(ClaimVerdict verdict) {
    switch (verdict) {
    case ClaimVerdict::right:
        return "right##verdict";
    case ClaimVerdict::wrong:
        return "wrong##verdict";
    case ClaimVerdict::follows:
        return "follows";
    case ClaimVerdict::not_understood:
        return "not understood";
    case ClaimVerdict::open:
        break;
    }
    return "open";
}

/// In the language of steps.
std::string_view in_words(ClaimVerdict verdict) {
    return words_of(verdict).in(language_of_steps());
}

/// With less than the answers only `wrong` for what follows from a wrong number.
std::string_view verdict_of(const CheckedClaim& claim, CheckTold told) {
    return in_words(told != CheckTold::answers && is_wrong(claim.verdict) ? ClaimVerdict::wrong
                                                                          : claim.verdict);
}

/// `; follows from line 2`, or `from its left end`, which is in the same line
std::string origin_of(const CheckedFile& file, const CheckedField& field,
                      std::size_t line_of_claim) {
    const std::string origin = field.follows_from == line_of_claim
                                   ? said("its {}", file.claims.in_words(field.follows_from_field))
                                   : said("line {}", field.follows_from);
    return said("; follows from {}{}", origin,
                field.follows_from_rounded ? said(", which is rounded") : "");
}

/// `first pixel: expected -1, found 0; follows from line 2`; of a list, a line for each wrong number.
std::string field_line(const CheckedFile& file, const CheckedField& field,
                       std::size_t line_of_claim) {
    constexpr std::size_t most_numbers = 8;
    const auto difference = [&](std::string_view expected, std::string_view found,
                                std::size_t place) {
        return "    " +
               difference_text(file.claims, field, shown_expected(expected), shown(found), place);
    };
    std::string line = difference(field.expected, field.found, field.place);
    std::size_t told = 1;
    for (const CheckedNumber& number : field.numbers)
        if (number.verdict == ClaimVerdict::wrong && number.place != field.place &&
            told++ < most_numbers)
            line += "\n" + difference(number.expected, number.found, number.place);
    if (field.verdict == ClaimVerdict::follows)
        line += origin_of(file, field, line_of_claim);
    if (!field.remark.empty())
        line += fmt::format(" ({})", printable(field.remark));
    return line + "\n";
}

/// The likely slips of a claim's fields, each once.
std::string slip_lines(const CheckedClaim& claim) {
    std::string lines;
    std::set<std::string> named;
    for (const CheckedField& field : claim.fields)
        for (const LikelySlip& slip : field.slips)
            if (named.size() < most_slips && named.insert(slip.name).second)
                lines += said("    likely slip {}: {}\n",
                              slip.name + place_in_list(slip.place, field.name),
                              printable(slip.meaning));
    return lines;
}

std::string indented(const std::vector<std::string>& lines, std::string_view indent) {
    std::string text;
    for (const std::string& line : lines)
        text += fmt::format("{}{}\n", indent, printable(line));
    return text;
}

/// What of a claim is wrong, and which slips are likely.
std::string differences(const CheckedFile& file, const CheckedClaim& claim) {
    std::string text;
    for (const CheckedField& field : claim.fields)
        if (is_wrong(field.verdict))
            text += field_line(file, field, file.claim_of(claim).line);
    return text + slip_lines(claim) + indented(claim.remarks, "    ") +
           indented(claim.picture, "    ");
}

/// A claim that is wrong, and why. What has been worked out for another claim is not written out again.
std::string wrong_claim(const CheckedFile& file, const CheckedClaim& claim,
                        std::map<std::vector<std::string>, std::size_t>& line_of_working) {
    const std::string text = place_of(file, claim) + "\n" + differences(file, claim);
    const auto [known, is_new] =
        line_of_working.try_emplace(claim.working, file.claim_of(claim).line);
    if (!is_new && !claim.working.empty())
        return text + said("        worked out as for line {}\n", known->second);
    return text + indented(claim.working, "        ");
}

/// What there is to be said of a claim that is right or open; most have nothing.
std::string remarks_in(const CheckedFile& file, const CheckedClaim& claim) {
    std::string text;
    for (const CheckedField& field : claim.fields)
        if (!field.remark.empty())
            text += fmt::format("    {}: {}, {}\n", file.claims.in_words(field.name),
                                in_words(field.verdict), printable(field.remark));
    return text + indented(claim.remarks, "    ");
}

/// Where a claim is wrong, by which rule, and perhaps by which formula; no number that is right.
std::string hints(const CheckedFile& file, const CheckedClaim& claim, CheckTold told) {
    std::string text;
    for (const CheckedField& field : claim.fields) {
        if (!is_wrong(field.verdict) || told == CheckTold::verdicts)
            continue;
        text += fmt::format("    {}{}\n", file.claims.in_words(field.name),
                            place_in_list(field.place, field.name));
        if (field.verdict == ClaimVerdict::follows)
            text += fmt::format("        {}\n",
                                origin_of(file, field, file.claim_of(claim).line).substr(2));
        if (!field.rule.empty())
            text += fmt::format("        {}\n", field.rule);
        if (told == CheckTold::formula && !field.formula.empty())
            text += fmt::format("        {}\n", field.formula);
    }
    return text;
}

std::string text_of_one(const CheckedFile& file, CheckTold told) {
    std::string text;
    std::map<std::vector<std::string>, std::size_t> line_of_working;
    for (const CheckedClaim& claim : file.checked.claims) {
        if (claim.problem && told == CheckTold::answers)
            text += to_text(*claim.problem) + "\n";
        else if (told != CheckTold::answers)
            text += fmt::format("{}: {}\n", place_of(file, claim), verdict_of(claim, told)) +
                    hints(file, claim, told);
        else if (is_wrong(claim.verdict))
            text += wrong_claim(file, claim, line_of_working);
        else if (const std::string remarks = remarks_in(file, claim); !remarks.empty())
            text += place_of(file, claim) + "\n" + remarks;
    }
    if (!file.checked.remark.empty())
        text += fmt::format("{}: {}\n", printable(file.name), file.checked.remark);
    if (file.claims.has_decimal_comma)
        text +=
            said("{}: commas are read as those of decimals: 0,25 is 1/4\n", printable(file.name));
    return text + (text.empty() ? "" : "\n") + counts_text(file.checked) + "\n";
}

/// "anna.txt: 12 right, 3 wrong; most likely truncate-for-floor\n"
std::string line_of_file(const CheckedFile& file, CheckTold told) {
    std::string text = printable(file.name);
    if (!file.exercise.empty())
        text += said(" (exercise {})", printable(file.exercise));
    if (file.problem)
        return text + said(": could not be checked\n");
    const auto& slips = file.checked.slips;
    return fmt::format("{}: {}{}\n", text, counts_text(file.checked),
                       told == CheckTold::answers && !slips.empty()
                           ? said("; most likely {}", slips.front())
                           : "");
}

/// The most likely slip of each sheet, and of how many sheets: the most frequent first.
std::string frequent_slips(const std::vector<CheckedFile>& files) {
    constexpr Words none("(no slip that is known)");
    std::map<std::string, std::size_t> counts;
    std::size_t name_width = 0;
    for (const CheckedFile& file : files)
        if (file.checked.wrong + file.checked.follow > 0) {
            const auto& slips = file.checked.slips;
            const std::string name(slips.empty() ? none.in(language_of_steps()) : slips.front());
            ++counts[name];
            name_width = std::max(name_width, name.size());
        }
    std::vector<std::pair<std::string, std::size_t>> slips(counts.begin(), counts.end());
    std::ranges::stable_sort(slips, std::ranges::greater(),
                             &std::pair<std::string, std::size_t>::second);
    std::string text;
    for (const auto& [name, count] : slips) {
        const std::string meaning = meaning_of(name);
        text += fmt::format("{:<{}}  {}{}{}\n", name, name_width, count,
                            meaning.empty() ? "" : "  ", meaning);
    }
    return text.empty()
               ? ""
               : said("\nThe most likely slip of a sheet, and of how many sheets:\n") + text;
}

// JSON: docs/check.md describes the keys.

/// {"left":"-1/4"}: a value of each field that is not as claimed.
JsonText field_values(const CheckedClaim& claim, std::string CheckedField::*value) {
    JsonText values{};
    for (const CheckedField& field : claim.fields)
        if (is_wrong(field.verdict))
            values.add(field.name, field.*value);
    return values;
}

std::vector<JsonText> slips_of(const CheckedClaim& claim) {
    std::vector<JsonText> slips;
    for (const CheckedField& field : claim.fields)
        for (const LikelySlip& slip : field.slips)
            slips.push_back(
                JsonText{{"field", field.name},
                         {"number", slip.place == 0 ? std::nullopt : std::optional(slip.place)},
                         {"name", slip.name},
                         {"meaning", slip.meaning}});
    return slips;
}

/// What was found of each list, number by number.
std::vector<JsonText> lists_of(const CheckedClaim& claim) {
    std::vector<JsonText> lists;
    for (const CheckedField& field : claim.fields)
        if (field.claimed_numbers > 0)
            lists.push_back(JsonText{{"field", field.name},
                                     {"right", field.right_numbers},
                                     {"claimed", field.claimed_numbers},
                                     {"ends_early", field.ends_early}}
                                .add("others", JsonText::list(field.numbers, [](const auto& one) {
                                         return JsonText{{"number", one.place},
                                                         {"verdict", name_of(one.verdict)},
                                                         {"expected", one.expected},
                                                         {"found", one.found}};
                                     })));
    return lists;
}

/// The line of the first number that it goes on from.
std::optional<std::size_t> follows_from(const CheckedClaim& claim) {
    for (const CheckedField& field : claim.fields)
        if (field.verdict == ClaimVerdict::follows)
            return field.follows_from;
    return std::nullopt;
}

/// Those of the claim, and those of its fields with their names.
std::vector<std::string> all_remarks(const CheckedClaim& claim) {
    std::vector<std::string> remarks = claim.remarks;
    for (const CheckedField& field : claim.fields)
        if (!field.remark.empty())
            remarks.push_back(field.name + ": " + field.remark);
    return remarks;
}

/// Adds where a claim is wrong, by which rule, and perhaps by which formula.
void add_hints(JsonText& json, const CheckedClaim& claim, CheckTold told) {
    std::vector<std::string> names;
    std::vector<std::string_view> rules;
    std::vector<std::string_view> formulas;
    for (const CheckedField& field : claim.fields)
        if (is_wrong(field.verdict)) {
            names.push_back(field.name);
            rules.push_back(field.rule);
            formulas.push_back(field.formula);
        }
    if (told == CheckTold::verdicts || names.empty())
        return;
    json.add("wrong", names).add("rules", rules);
    if (told == CheckTold::formula)
        json.add("formulas", formulas);
}

JsonText json_of(const CheckedFile& file, const CheckedClaim& claim, CheckTold told) {
    const Claim& claimed = file.claim_of(claim);
    const bool is_open = claim.verdict == ClaimVerdict::open || claim.problem;
    JsonText json{{"line", claimed.line},
                  {"claim", claimed.text},
                  {"right", is_open ? std::nullopt : std::optional(!is_wrong(claim.verdict))}};
    if (claim.problem)
        json.add("verdict", name_of(claim.verdict)).add("problem", to_text(*claim.problem));
    else if (told == CheckTold::answers)
        json.add("verdict", name_of(claim.verdict))
            .add("expected", field_values(claim, &CheckedField::expected))
            .add("found", field_values(claim, &CheckedField::found))
            .add("remarks", all_remarks(claim))
            .add("working", claim.working)
            .add("slips", slips_of(claim))
            .add("lists", lists_of(claim))
            .add("follows_from", follows_from(claim))
            .add("picture", claim.picture);
    else
        add_hints(json, claim, told);
    return json;
}

JsonText json_of(const CheckedFile& file, CheckTold told) {
    JsonText json{{"file", file.name}};
    if (file.problem)
        return json.add("problem", to_text(*file.problem));
    if (!file.exercise.empty())
        json.add("exercise", file.exercise);
    const Checked& checked = file.checked;
    return json.add("right", checked.right)
        .add("wrong", checked.wrong)
        .add("follow", checked.follow)
        .add("open", checked.open)
        .add("not_understood", checked.not_understood)
        .add("remark", checked.remark)
        .add("claims", JsonText::lines(checked.claims, [&](const CheckedClaim& claim) {
                 return json_of(file, claim, told);
             }));
}

} // namespace

std::string_view name_of(ClaimVerdict verdict) {
    return words_of(verdict).in(Language::english);
}

bool is_wrong(ClaimVerdict verdict) {
    return verdict == ClaimVerdict::wrong || verdict == ClaimVerdict::follows;
}

std::string counts_text(const Checked& checked) {
    const auto count_of = [](std::size_t count, const Words& one, const Words& more) {
        return fmt::format("{} {}", count, (count == 1 ? one : more).in(language_of_steps()));
    };
    std::string text = count_of(checked.right, "right##verdict", "right##verdicts") + ", " +
                       count_of(checked.wrong, "wrong##verdict", "wrong##verdicts");
    if (checked.follow > 0)
        text += ", " + count_of(checked.follow, "that follows", "that follow");
    if (checked.open > 0)
        text += said(", {} open", checked.open);
    if (checked.not_understood > 0)
        text += said(", {} not understood", checked.not_understood);
    return text;
}

std::string check_text(const std::vector<CheckedFile>& files, CheckTold told) {
    if (files.size() == 1)
        return text_of_one(files.front(), told);
    std::string text;
    for (const CheckedFile& file : files)
        text += line_of_file(file, told);
    return told == CheckTold::answers ? text + frequent_slips(files) : text;
}

JsonText check_json(const std::vector<CheckedFile>& files, CheckTold told) {
    if (files.size() == 1)
        return json_of(files.front(), told);
    return JsonText::lines(files, [told](const CheckedFile& file) { return json_of(file, told); });
}

} // namespace rastertrace
