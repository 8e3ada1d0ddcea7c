// SPDX-License-Identifier: MIT
// `rastertrace renew`: the commands on Markdown pages, run again.

#include "commands.h"
#include "load.h"
#include "page.h"
#include "page_files.h"
#include "run_self.h"

#include <rastertrace/core/scene/stages.h>
#include <rastertrace/trace/output.h>
#include <rastertrace/trace/text.h>

#include <fmt/core.h>

#include <algorithm>
#include <cstddef>
#include <filesystem>
#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace rastertrace {

namespace {

/// A file of an earlier run that a command writes no more.
struct LeftOverFile {
    std::string path;
    Problem problem;
};

/// A page, and what its commands print now.
struct RenewedPage {
    Source page;
    std::vector<PageCommand> commands;
    std::vector<std::string> outputs;       ///< one for each command
    std::vector<Problem> stale_files;       ///< that its commands would write otherwise
    std::vector<std::string> written_files; ///< by its commands, if it is only checked
    std::vector<LeftOverFile> left_over;
};

std::string_view first_line_of(std::string_view text) {
    return text.substr(0, text.find('\n'));
}

std::string in_words(int exit_status) {
    return exit_status == 0 ? "success" : fmt::format("exit status {}", exit_status);
}

/// A command that ended otherwise than its page says.
Problem problem_of_exit(const Source& page, const PageCommand& command, const FinishedRun& run) {
    const bool has_to_succeed = command.exit_status == 0;
    std::string hint;
    if (!run.err.empty())
        hint = fmt::format("it says: {}", first_line_of(run.err));
    else if (has_to_succeed)
        hint = fmt::format("if it has to fail, write # exit {} behind it", run.exit_status);
    Problem problem = problem_at(
        page, command.begin,
        fmt::format("expected {}, found {}",
                    has_to_succeed ? "a command that succeeds" : in_words(command.exit_status),
                    in_words(run.exit_status)),
        std::move(hint));
    if (run.exit_status == exit_system)
        problem.cause = Problem::Cause::system;
    return problem;
}

/// Runs a command, with these words; returns its output for the page.
std::string output_of(const Source& page, const PageCommand& command,
                      const std::vector<std::string>& words) {
    if (!command.words.empty() && command.words.front() == "renew")
        throw problem_at(page, command.begin,
                         "expected a command that shows something, found renew");

    const FinishedRun run = run_self(words);
    if (run.is_too_large)
        throw problem_at(page, command.begin,
                         fmt::format("expected a command that prints at most {} MB, found more",
                                     most_output / 1'000'000));
    if (run.exit_status != command.exit_status)
        throw problem_of_exit(page, command, run);
    return output_for(page, command, run.out + run.err);
}

/// Runs the commands of a page. One that is only checked leaves the files that they write as they are.
RenewedPage renew_page(const std::string& path, bool is_checked) {
    RenewedPage renewed{.page = load_page(path),
                        .commands = {},
                        .outputs = {},
                        .stale_files = {},
                        .written_files = {},
                        .left_over = {}};
    renewed.commands = commands_on(renewed.page);
    for (const PageCommand& command : renewed.commands) {
        if (!is_checked || command.exit_status != 0 || !writes_file(command.words)) {
            renewed.outputs.push_back(output_of(renewed.page, command, command.words));
            continue;
        }
        const OutputElsewhere elsewhere(command.words);
        renewed.outputs.push_back(output_of(renewed.page, command, elsewhere.words()));
        for (const std::string& file : elsewhere.stale_files())
            renewed.stale_files.push_back(problem_at(
                renewed.page, command.begin,
                fmt::format("expected {} as this command writes it, found another file, or none",
                            printable(file))));
        for (const std::string& file : elsewhere.left_over_files())
            renewed.left_over.push_back(
                {file, problem_at(renewed.page, command.begin,
                                  fmt::format("expected no {}, which this command no longer "
                                              "writes, found it",
                                              printable(file)),
                                  "renew leaves it; remove it if nothing else needs it")});
        for (std::string& file : elsewhere.written_files())
            renewed.written_files.push_back(std::move(file));
    }
    return renewed;
}

/// A line of an output, for a message.
std::string line_in_words(std::string_view output, std::size_t begin) {
    return begin == output.size() ? "the end of the output"
                                  : fmt::format("\"{}\"", first_line_of(output.substr(begin)));
}

/// The first place where the page does not have what a command prints now.
std::optional<Problem> difference_in(const Source& page, const PageCommand& command,
                                     std::string_view printed) {
    const std::string_view shown = std::string_view(page.text).substr(
        command.output_begin, command.output_end - command.output_begin);
    if (shown == printed)
        return std::nullopt;
    const auto differs = std::mismatch(shown.begin(), shown.end(), printed.begin(), printed.end());
    auto place = static_cast<std::size_t>(differs.first - shown.begin());
    // Back to the first byte of its character.
    while (place > 0 && place < shown.size() && (shown[place] & 0xC0) == 0x80)
        --place;
    // Both are alike before, so that the line begins at one place in both.
    const std::size_t line = shown.substr(0, place).rfind('\n') + 1;
    return problem_at(page, command.output_begin + place,
                      fmt::format("expected {}, found {}", line_in_words(printed, line),
                                  line_in_words(shown, line)),
                      fmt::format("line {} is {}", command.line, command.text));
}

/// Where the page does not have what its commands print now; at most one place for each.
std::vector<Problem> differences_in(const RenewedPage& renewed) {
    std::vector<Problem> differences;
    for (std::size_t i = 0; i < renewed.commands.size(); ++i)
        if (auto one = difference_in(renewed.page, renewed.commands[i], renewed.outputs[i]))
            differences.push_back(*std::move(one));
    return differences;
}

/// Tells what is stale on the pages, and how to renew it.
ExitStatus check(const std::vector<RenewedPage>& pages) {
    // What one command writes no more another one may write.
    std::set<std::filesystem::path> written;
    for (const RenewedPage& page : pages)
        for (const std::string& file : page.written_files)
            written.insert(std::filesystem::path(file).lexically_normal());
    bool has_left_over = false;
    std::string stale;
    for (const RenewedPage& page : pages) {
        std::vector<Problem> differences = differences_in(page);
        differences.insert(differences.end(), page.stale_files.begin(), page.stale_files.end());
        for (const Problem& difference : differences)
            print(to_text(difference) + "\n");
        if (!differences.empty())
            stale += " " + printable(page.page.name);
        for (const LeftOverFile& file : page.left_over)
            if (!written.contains(std::filesystem::path(file.path).lexically_normal())) {
                print(to_text(file.problem) + "\n");
                has_left_over = true;
            }
    }
    if (!stale.empty())
        print("to renew: rastertrace renew" + stale + "\n");
    return stale.empty() && !has_left_over ? exit_fine : exit_difference;
}

/// Writes the page if it is stale, and tells how much of it was.
void write(const RenewedPage& renewed) {
    const std::size_t stale = differences_in(renewed).size();
    if (stale > 0) {
        FileOutput output(renewed.page.name);
        output.write(with_outputs(renewed.page, renewed.commands, renewed.outputs));
        output.commit();
    }
    print(fmt::format("{}: {}, {} renewed\n", printable(renewed.page.name),
                      counted(renewed.commands.size(), "command"), stale));
}

} // namespace

int run(const RenewCommand& command) {
    // A page with a mistake leaves all of them as they were.
    std::vector<RenewedPage> pages;
    for (const std::string& path : command.pages)
        pages.push_back(renew_page(path, command.check));

    if (command.check)
        return check(pages);
    for (const RenewedPage& page : pages)
        write(page);
    return exit_fine;
}

} // namespace rastertrace
