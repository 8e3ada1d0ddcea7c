// SPDX-License-Identifier: MIT
// docs/check.md describes the keys.

#include "commands/check_report.h"

#include <rastertrace/trace/record/write_trace.h>
#include <rastertrace/trace/text/text.h>

#include <fmt/core.h>

#include <string>

namespace rastertrace {

namespace {

/// ["a","b"]
std::string array_of(const std::vector<std::string>& lines) {
    std::vector<std::string> quoted;
    for (const std::string& line : lines)
        quoted.push_back(json_quoted(line));
    return "[" + joined(quoted, ",") + "]";
}

/// {"left":"-1/4"}: a value of each field that is not as claimed.
std::string values_of(const CheckedClaim& claim, std::string CheckedField::*value) {
    std::vector<std::string> members;
    for (const CheckedField& field : claim.fields)
        if (is_wrong(field.verdict))
            members.push_back(json_quoted(field.name) + ":" + json_quoted(field.*value));
    return "{" + joined(members, ",") + "}";
}

std::string slips_of(const CheckedClaim& claim) {
    std::vector<std::string> slips;
    for (const CheckedField& field : claim.fields)
        for (const LikelySlip& slip : field.slips)
            slips.push_back(fmt::format(R"({{"field":{},"name":{},"meaning":{}}})",
                                        json_quoted(field.name), json_quoted(slip.name),
                                        json_quoted(slip.meaning)));
    return "[" + joined(slips, ",") + "]";
}

/// The line of the first number that it goes on from, or null.
std::string follows_from(const CheckedClaim& claim) {
    for (const CheckedField& field : claim.fields)
        if (field.verdict == ClaimVerdict::follows)
            return std::to_string(field.follows_from);
    return "null";
}

/// Those of the claim, and those of its fields with their names.
std::string remarks_on(const CheckedClaim& claim) {
    std::vector<std::string> remarks = claim.remarks;
    for (const CheckedField& field : claim.fields)
        if (!field.remark.empty())
            remarks.push_back(field.name + ": " + field.remark);
    return array_of(remarks);
}

/// ,"wrong":["left"],"rules":["..."],"formulas":["..."]: of each field that is wrong.
std::string hint_members(const CheckedClaim& claim, CheckTold told) {
    std::vector<std::string> names;
    std::vector<std::string> rules;
    std::vector<std::string> formulas;
    for (const CheckedField& field : claim.fields)
        if (is_wrong(field.verdict)) {
            names.push_back(field.name);
            rules.emplace_back(field.rule);
            formulas.emplace_back(field.formula);
        }
    if (told == CheckTold::verdicts || names.empty())
        return "";
    const std::string text =
        fmt::format(R"(,"wrong":{},"rules":{})", array_of(names), array_of(rules));
    return told == CheckTold::rule ? text : text + R"(,"formulas":)" + array_of(formulas);
}

std::string as_json(const CheckedFile& file, const CheckedClaim& claim, CheckTold told) {
    const Claim& claimed = file.claim_of(claim);
    std::string text =
        fmt::format(R"({{"line":{},"claim":{},"right":{})", claimed.line, json_quoted(claimed.text),
                    claim.verdict == ClaimVerdict::open ? "null"
                    : is_wrong(claim.verdict)           ? "false"
                                                        : "true");
    if (told != CheckTold::answers)
        return text + hint_members(claim, told) + "}";
    text += fmt::format(R"(,"verdict":"{}","expected":{},"found":{},"remarks":{})",
                        name_of(claim.verdict), values_of(claim, &CheckedField::expected),
                        values_of(claim, &CheckedField::found), remarks_on(claim));
    return text + fmt::format(R"(,"working":{},"slips":{},"follows_from":{},"picture":{}}})",
                              array_of(claim.working), slips_of(claim), follows_from(claim),
                              array_of(claim.picture));
}

std::string as_json(const CheckedFile& file, CheckTold told) {
    if (file.problem)
        return fmt::format(R"({{"file":{},"problem":{}}})", json_quoted(file.name),
                           json_quoted(to_text(*file.problem)));
    const Checked& checked = file.checked;
    std::string text =
        fmt::format(R"({{"file":{}{},"right":{},"wrong":{},"follow":{},"open":{},"claims":[)",
                    json_quoted(file.name),
                    file.exercise.empty() ? "" : R"(,"exercise":)" + json_quoted(file.exercise),
                    checked.right, checked.wrong, checked.follow, checked.open);
    std::string_view separator = "\n";
    for (const CheckedClaim& claim : checked.claims) {
        text += separator;
        text += as_json(file, claim, told);
        separator = ",\n";
    }
    return text + "\n]}";
}

} // namespace

std::string check_json(const std::vector<CheckedFile>& files, CheckTold told) {
    if (files.size() == 1)
        return as_json(files.front(), told) + "\n";
    std::vector<std::string> all;
    for (const CheckedFile& file : files)
        all.push_back(as_json(file, told));
    return "[" + joined(all, ",\n") + "]\n";
}

} // namespace rastertrace
