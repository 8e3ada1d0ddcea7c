// SPDX-License-Identifier: MIT
#include "check_class.h"

#include "claims_checker.h"
#include "files_below.h"
#include "job_runner.h"

#include <rastertrace/trace/check/claims.h>
#include <rastertrace/trace/check/slips.h>
#include <rastertrace/trace/tell/step_text.h>
#include <rastertrace/trace/text/in_threads.h>
#include <rastertrace/trace/text/language.h>
#include <rastertrace/trace/text/text.h>

#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <filesystem>
#include <map>

namespace rastertrace {

namespace {

namespace fs = std::filesystem;

/// Sheets are text; of .json, those with claims.
bool may_be_sheet(const fs::path& path) {
    constexpr std::array endings{".txt", ".claims", ".csv", ".md", ".json"};
    return std::ranges::find(endings, path.extension()) != endings.end();
}

/// The mark of one sheet; nothing for a file that is none.
std::optional<SheetMark> mark_in(const std::string& folder, const std::string& name,
                                 ClaimsChecker& checker) {
    std::string exercise;
    try {
        auto source = value_or_throw(read_named_file((fs::path(folder) / name).string(), {}));
        if (name.ends_with(".json") && !is_claims(source))
            return std::nullopt;
        exercise = checker.exercise_of(source);
        SheetMark mark = mark_of(checker.check(std::move(source)));
        mark.name = name;
        return mark;
    } catch (const Problem& problem) {
        return SheetMark{.name = name, .exercise = exercise, .problem = problem};
    }
}

/// Students with several sheets, and exercises that several sheets are about.
std::vector<std::string> duplicates_in(const std::vector<SheetMark>& sheets) {
    std::map<std::string, std::vector<std::string>> names_of;
    for (const SheetMark& sheet : sheets) {
        const std::string student = fs::path(sheet.name).begin()->stem().string();
        names_of[student].push_back(sheet.name);
        if (!sheet.exercise.empty())
            names_of["exercise " + sheet.exercise].push_back(sheet.name);
    }
    std::vector<std::string> told;
    for (const auto& [whose, names] : names_of)
        if (names.size() > 1)
            told.push_back(fmt::format("{} sheets of {}: {}", names.size(), printable(whose),
                                       printable(joined(names, ", "))));
    return told;
}

/// The names of files; of many, "30 .json, 30 .svg".
std::string left_out_in_words(const std::vector<std::string>& names) {
    constexpr std::size_t few = 5;
    if (names.size() <= few)
        return printable(joined(names, ", "));
    std::map<std::string, std::size_t> by_ending;
    for (const std::string& name : names)
        ++by_ending[fs::path(name).extension().string()];
    std::vector<std::string> told;
    for (const auto& [ending, count] : by_ending)
        told.push_back(fmt::format("{} {}", count,
                                   ending.empty() ? said({"without an ending", "sem extensão"})
                                                  : printable(ending)));
    return joined(told, ", ");
}

/// A slip, and of how many sheets it is the most likely one.
struct SlipCount {
    std::string name; ///< empty: wrong numbers that no slip explains
    std::size_t sheets = 0;
};

/// The most frequent first.
std::vector<SlipCount> slip_counts(const std::vector<SheetMark>& sheets) {
    std::map<std::string, std::size_t> counts;
    for (const SheetMark& sheet : sheets)
        if (!sheet.problem && sheet.counts.wrong + sheet.counts.follow > 0)
            ++counts[sheet.counts.slips.empty() ? "" : sheet.counts.slips.front()];
    std::vector<SlipCount> slips;
    for (const auto& [name, count] : counts)
        slips.push_back({name, count});
    std::ranges::stable_sort(slips, std::ranges::greater(), &SlipCount::sheets);
    return slips;
}

/// "truncate-for-floor", or what stands for none.
std::string_view shown_name(const SlipCount& slip) {
    constexpr Words none("(no slip that is known)", "(nenhum deslize conhecido)");
    return slip.name.empty() ? none.in(language_of_steps()) : slip.name;
}

} // namespace

ClassMarks mark_class(const std::string& folder,
                      const std::function<ClaimsChecker()>& make_checker) {
    ClassMarks marks;
    std::vector<std::string> names;
    for (std::string& name : files_below(folder, "sheets"))
        (may_be_sheet(name) ? names : marks.left_out).push_back(std::move(name));

    const std::size_t jobs = usual_jobs();
    std::vector<ClaimsChecker> checkers;
    for (std::size_t i = 0; i < jobs; ++i)
        checkers.push_back(make_checker());
    std::vector<std::optional<SheetMark>> found(names.size());
    JobRunner runner({.doing = "check", .unit = "sheets", .count = names.size(), .at_once = jobs});
    runner.run([&](std::size_t i, std::size_t thread) {
        found[i] = mark_in(folder, names[i], checkers[thread]);
    });
    for (std::size_t i = 0; i < names.size(); ++i) {
        if (found[i])
            marks.sheets.push_back(*std::move(found[i]));
        else
            marks.left_out.push_back(names[i]);
    }
    if (marks.sheets.empty())
        throw problem_of(
            folder, "expected sheets, found none",
            "a file of claims that ends in .txt, .claims, .csv, .md or .json for each student");
    std::ranges::sort(marks.left_out);
    marks.duplicates = duplicates_in(marks.sheets);
    return marks;
}

std::string class_text(const ClassMarks& marks) {
    std::string text;
    std::size_t all_right = 0;
    for (const SheetMark& sheet : marks.sheets) {
        text += mark_in_words(sheet, CheckTold::answers);
        const Checked& counts = sheet.counts;
        if (!sheet.problem && counts.wrong + counts.follow + counts.open == 0)
            ++all_right;
    }
    text += said({"\n{}, {} all right\n", "\n{}, {} com tudo certo\n"},
                 said_count(marks.sheets.size(), {"sheet", "folha"}), all_right);
    const auto slips = slip_counts(marks.sheets);
    if (!slips.empty())
        text += said({"\nThe most likely slip of a sheet, and of how many sheets:\n",
                      "\nO deslize mais provável de uma folha, e de quantas folhas:\n"});
    constexpr std::size_t longest_bar = 40;
    std::size_t name_width = 0;
    for (const SlipCount& slip : slips)
        name_width = std::max(name_width, shown_name(slip).size());
    for (const SlipCount& slip : slips) {
        const std::size_t length =
            slips.front().sheets <= longest_bar
                ? slip.sheets
                : std::max<std::size_t>(1, longest_bar * slip.sheets / slips.front().sheets);
        const Slip* const known = find_slip(slip.name);
        text +=
            fmt::format("{:<{}}  {} {}{}\n", shown_name(slip), name_width, std::string(length, '#'),
                        slip.sheets, known ? "  " + meaning_of(*known) : "");
    }
    if (!marks.left_out.empty())
        text += said({"\nno sheets: {}\n", "\nnão são folhas: {}\n"},
                     left_out_in_words(marks.left_out));
    return text;
}

Drawing slip_chart(const std::vector<SheetMark>& sheets) {
    constexpr double size = 12;
    constexpr double line_height = 22;
    constexpr double margin = 16;
    constexpr double names_end = 230;
    constexpr double longest_bar = 300;
    const auto slips = slip_counts(sheets);
    Drawing chart{.width = names_end + longest_bar + 60,
                  .height = 2 * margin + static_cast<double>(slips.size() + 1) * line_height,
                  .title = said({"The most likely slips in {} sheets",
                                 "Os deslizes mais prováveis em {} folhas"},
                                sheets.size())};
    chart.shapes.push_back(Label{.role = Role::strong_text,
                                 .at = {margin, margin + size},
                                 .text = chart.title,
                                 .size = size});
    double top = margin + line_height;
    for (const SlipCount& slip : slips) {
        const double length = longest_bar * static_cast<double>(slip.sheets) /
                              static_cast<double>(slips.front().sheets);
        chart.shapes.push_back(Label{.at = {names_end - 8, top + size},
                                     .text = std::string(shown_name(slip)),
                                     .size = size,
                                     .anchor = Anchor::end});
        chart.shapes.push_back(
            Areas{.role = Role::bar, .rectangles = {{{names_end, top}, length, line_height - 6}}});
        chart.shapes.push_back(Label{.at = {names_end + length + 6, top + size},
                                     .text = std::to_string(slip.sheets),
                                     .size = size});
        top += line_height;
    }
    return chart;
}

} // namespace rastertrace
