// SPDX-License-Identifier: MIT
// A table for each file, to be pasted into an issue or a forum.

#include "check_report.h"
#include "markdown.h"

#include <rastertrace/trace/tell/step_text.h>
#include <rastertrace/trace/text/text.h>

#include <fmt/core.h>

namespace rastertrace {

namespace {

std::string table_of(const CheckedFile& file, CheckTold told) {
    std::string text =
        said({"| line | claim | |\n|---|---|---|\n", "| linha | item | |\n|---|---|---|\n"});
    std::string details;
    for (const CheckedClaim& claim : file.checked.claims) {
        text += fmt::format("| {} | {} | {} |\n", file.claim_of(claim).line,
                            in_markdown(file.claim_of(claim).text), verdict_of(claim, told));
        const std::string about = about_claim(file, claim, told);
        if (!about.empty())
            details += fmt::format("{}\n{}", place_of(file, claim), about);
    }
    if (!details.empty())
        text += fmt::format("\n<details><summary>{}</summary>\n\n{}\n</details>\n",
                            said({"What is wrong", "O que está errado"}), fenced(details));
    return text;
}

} // namespace

std::string check_markdown(const std::vector<CheckedFile>& files, CheckTold told) {
    std::string text;
    for (const CheckedFile& file : files)
        text +=
            fmt::format("{}### {}\n\n{}", text.empty() ? "" : "\n", in_markdown(file.name),
                        file.problem ? fenced(to_text(*file.problem) + "\n")
                                     : counts_text(file.checked) + "\n\n" + table_of(file, told));
    return text;
}

} // namespace rastertrace
