// SPDX-License-Identifier: MIT
// A test suite for each file, a test case for each claim.

#include "check_report.h"
#include "junit.h"

#include <rastertrace/figures/svg.h>
#include <rastertrace/trace/tell/step_text.h>
#include <rastertrace/trace/text/text.h>

#include <fmt/core.h>

namespace rastertrace {

namespace {

/// `left end: expected -1/4, found 0; right end: ...`
std::string message_of(const CheckedFile& file, const CheckedClaim& claim) {
    std::vector<std::string> parts;
    for (const CheckedField& field : claim.fields)
        if (is_wrong(field.verdict))
            parts.push_back(file.difference(field, field.expected, field.found));
    parts.insert(parts.end(), claim.remarks.begin(), claim.remarks.end());
    return parts.empty() ? std::string(in_words(ClaimVerdict::wrong)) : joined(parts, "; ");
}

/// The likely slips, the picture and the working, a line each.
std::string body_of(const CheckedFile& file, const CheckedClaim& claim) {
    std::string text;
    for (const CheckedField& field : claim.fields)
        for (const LikelySlip& slip : field.slips)
            text += said({"{}: likely slip {}: {}\n", "{}: deslize provável {}: {}\n"},
                         file.in_words(field.name), slip.name, slip.meaning);
    for (const auto* lines : {&claim.picture, &claim.working})
        for (const std::string& line : *lines)
            text += line + "\n";
    return text;
}

std::string test_case(const CheckedFile& file, const CheckedClaim& claim, CheckTold told) {
    const Claim& claimed = file.claim_of(claim);
    const std::string head =
        fmt::format(R"(    <testcase classname="{}" name="{}")", escaped(file.name),
                    said({"line {}: {}", "linha {}: {}"}, claimed.line, escaped(claimed.text)));
    if (claim.verdict == ClaimVerdict::open)
        return head + "><skipped/></testcase>\n";
    if (!is_wrong(claim.verdict))
        return head + "/>\n";
    return head +
           fmt::format(">\n      <failure message=\"{}\">{}</failure>\n    </testcase>\n",
                       told == CheckTold::answers ? escaped(message_of(file, claim))
                                                  : std::string(in_words(ClaimVerdict::wrong)),
                       escaped_lines(told == CheckTold::answers ? body_of(file, claim)
                                                                : about_claim(file, claim, told)));
}

std::string test_suite(const CheckedFile& file, CheckTold told) {
    const std::string name = escaped(file.name);
    if (file.problem)
        return fmt::format("  <testsuite name=\"{0}\" tests=\"1\" failures=\"0\" errors=\"1\" "
                           "skipped=\"0\">\n    <testcase classname=\"{0}\" name=\"{0}\">\n"
                           "      <error message=\"{1}\">{2}</error>\n    </testcase>\n"
                           "  </testsuite>\n",
                           name, escaped(file.problem->message),
                           escaped_lines(to_text(*file.problem)));
    const Checked& checked = file.checked;
    std::string text =
        fmt::format("  <testsuite name=\"{}\" tests=\"{}\" failures=\"{}\" "
                    "errors=\"0\" skipped=\"{}\">\n",
                    name, checked.claims.size(), checked.wrong + checked.follow, checked.open);
    for (const CheckedClaim& claim : checked.claims)
        text += test_case(file, claim, told);
    return text + "  </testsuite>\n";
}

} // namespace

std::string check_junit(const std::vector<CheckedFile>& files, CheckTold told) {
    std::string suites;
    for (const CheckedFile& file : files)
        suites += test_suite(file, told);
    return junit_document(suites);
}

} // namespace rastertrace
