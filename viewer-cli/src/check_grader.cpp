// SPDX-License-Identifier: MIT
// The files that Gradescope (Autograder Specifications, "Output Format") and PrairieLearn (External grading, "Grading
// results") take marks from: a test of one point for each mark.

#include "check_report.h"

#include <rastertrace/trace/record/write_trace.h>
#include <rastertrace/trace/tell/step_text.h>
#include <rastertrace/trace/text/text.h>

#include <fmt/core.h>

#include <string>
#include <vector>

namespace rastertrace {

namespace {

/// A claim as a test.
struct GradedClaim {
    std::string name;
    std::string output;
    std::string_view verdict;
    int points = 0; ///< of 1
};

std::vector<GradedClaim> graded(const std::vector<CheckedFile>& files, CheckTold told) {
    std::vector<GradedClaim> tests;
    for (const CheckedFile& file : files)
        for (const Mark& mark : file.marks) {
            GradedClaim test{.name = {},
                             .output = {},
                             .verdict = in_words(mark.verdict),
                             .points = points_of(mark.verdict)};
            for (const std::size_t i : mark.claims) {
                const CheckedClaim& claim = file.checked.claims[i];
                test.name +=
                    said({"{}line {}: {}", "{}linha {}: {}"}, test.name.empty() ? "" : "; ",
                         file.claim_of(claim).line, shown_claim(file.claim_of(claim)));
                test.output += about_claim(file, claim, told);
            }
            if (mark.claims.empty())
                test.name = printable(mark.asked);
            if (files.size() > 1)
                test.name = fmt::format("{}: {}", printable(file.name), test.name);
            tests.push_back(std::move(test));
        }
    return tests;
}

std::string counts_of(const std::vector<CheckedFile>& files) {
    std::string text;
    for (const CheckedFile& file : files)
        text += (file.problem ? to_text(*file.problem) : counts_text(file.checked)) + "\n";
    return text;
}

} // namespace

std::string check_gradescope(const std::vector<CheckedFile>& files, CheckTold told,
                             std::string_view visibility) {
    std::vector<std::string> tests;
    for (const GradedClaim& test : graded(files, told))
        tests.push_back(fmt::format(
            R"({{"name":{},"score":{},"max_score":1,"status":"{}","output":{},"output_format":"text","visibility":"{}"}})",
            json_quoted(test.name), test.points, test.points > 0 ? "passed" : "failed",
            json_quoted(test.output), visibility));
    return fmt::format(R"({{{}"output":{},"output_format":"text","tests":[)"
                       "\n{}\n]}}\n",
                       tests.empty() ? R"("score":0,)" : "", json_quoted(counts_of(files)),
                       joined(tests, ",\n"));
}

std::string check_prairielearn(const std::vector<CheckedFile>& files, CheckTold told) {
    std::vector<std::string> faults;
    for (const CheckedFile& file : files)
        if (file.problem)
            faults.push_back(json_quoted(to_text(*file.problem)));
    if (!faults.empty()) // costs no attempt
        return fmt::format("{{\"gradable\":false,\"format_errors\":[{}]}}\n", joined(faults, ","));

    std::vector<std::string> tests;
    int points = 0;
    for (const GradedClaim& test : graded(files, told)) {
        points += test.points;
        tests.push_back(fmt::format(
            R"({{"name":{},"points":{},"max_points":1,"message":"{}","output":{}}})",
            json_quoted(test.name), test.points, test.verdict, json_quoted(test.output)));
    }
    return fmt::format(R"({{"gradable":true,"score":{},"message":{},"tests":[)"
                       "\n{}\n]}}\n",
                       static_cast<double>(points) / static_cast<double>(tests.size()),
                       json_quoted(counts_of(files)), joined(tests, ",\n"));
}

} // namespace rastertrace
