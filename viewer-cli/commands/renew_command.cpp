// SPDX-License-Identifier: MIT
// `rastertrace renew`: the commands on Markdown pages, run again.

#include "app/command.h"
#include "app/load.h"
#include "app/page.h"
#include "app/run_program.h"

#include <rastertrace/core/draw/plan/stages.h>
#include <rastertrace/trace/text/input.h>
#include <rastertrace/trace/text/output.h>
#include <rastertrace/trace/text/text.h>

#include <fmt/core.h>

#include <algorithm>
#include <cstddef>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace rastertrace {

namespace {

/// A page, and what its commands print now.
struct RenewedPage {
    Source page;
    std::vector<PageCommand> commands{};
    std::vector<std::string> outputs{}; ///< one for each command
    std::vector<Problem> stale_files{}; ///< that a page that is only checked would write otherwise
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

/// Runs a command, which writes its files below a folder, or, if that is "", where they belong; returns its output for
/// the page.
std::string output_of(const Source& page, const PageCommand& command, const std::string& folder,
                      const std::vector<std::string>& pages) {
    if (!command.words.empty() && command.words.front() == "renew")
        throw problem_at(page, command.begin,
                         "expected a command that shows something, found renew");
    const FinishedRun run = run_self(command.words, folder, pages);
    if (run.is_too_long)
        throw problem_at(page, command.begin,
                         fmt::format("expected a command that ends within {} min, found one that "
                                     "takes longer",
                                     time_of_run.count()));
    if (run.is_too_large)
        throw problem_at(page, command.begin,
                         fmt::format("expected a command that prints at most {} MB, found more",
                                     most_output / 1'000'000));
    if (run.exit_status != command.exit_status)
        throw problem_of_exit(page, command, run);
    return output_for(page, command, run.out + run.err);
}

std::string content_of(const std::filesystem::path& path) {
    std::ifstream file(path, std::ios::binary);
    return {std::istreambuf_iterator<char>(file), {}};
}

/// The files that were written below a folder and that are otherwise, or not there, where they belong; by name.
std::vector<std::string> stale_files(const std::filesystem::path& folder) {
    std::vector<std::string> stale;
    for (const auto& file : std::filesystem::recursive_directory_iterator(folder)) {
        const auto place = "/" / file.path().lexically_relative(folder);
        if (file.is_regular_file() && (!std::filesystem::is_regular_file(place) ||
                                       content_of(place) != content_of(file.path())))
            stale.push_back(place.lexically_proximate(std::filesystem::canonical(".")));
    }
    std::ranges::sort(stale);
    return stale;
}

/// Runs the commands of a page. One that is only checked leaves all files as they are.
RenewedPage renew_page(const std::string& path, bool is_only_checked,
                       const std::vector<std::string>& pages) {
    RenewedPage renewed{.page = load_page(path)};
    renewed.commands = commands_on(renewed.page);
    for (const PageCommand& command : renewed.commands) {
        std::optional<TemporaryFolder> files;
        if (is_only_checked)
            files.emplace("rastertrace-page");
        renewed.outputs.push_back(
            output_of(renewed.page, command, files ? files->path().string() : "", pages));
        for (const std::string& file :
             files ? stale_files(files->path()) : std::vector<std::string>())
            renewed.stale_files.push_back(problem_at(
                renewed.page, command.begin,
                fmt::format("expected {} as this command writes it, found another file, or none",
                            printable(file))));
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
    std::string stale;
    for (const RenewedPage& page : pages) {
        std::vector<Problem> differences = differences_in(page);
        differences.insert(differences.end(), page.stale_files.begin(), page.stale_files.end());
        for (const Problem& difference : differences)
            print(to_text(difference) + "\n");
        if (!differences.empty())
            stale += " " + printable(page.page.name);
    }
    if (!stale.empty())
        print("to renew: rastertrace renew" + stale + "\n");
    return stale.empty() ? exit_fine : exit_difference;
}

/// Writes the pages that are stale: all of them, or none.
void write(const std::vector<RenewedPage>& pages) {
    FileOutputs outputs;
    for (const RenewedPage& page : pages)
        if (!differences_in(page).empty())
            outputs.open(page.page.name)
                .write(with_outputs(page.page, page.commands, page.outputs));
    outputs.commit();
}

class RenewCommand final : public Command {
public:
    CommandAbout about() const override {
        return {
            "renew", "Run the commands on Markdown pages again and put their output there",
            "rastertrace renew docs/pages.md --check\n\n"
            "In a fenced code block, a line that begins with `$ rastertrace ` is a command; what\n"
            "follows, to the next line that begins with `$ ` or to the end of the block, is its\n"
            "output. A command that has to fail says so: $ rastertrace show bad.json # exit 2"};
    }

    void add_to(OptionList& options) override {
        options
            .option("page", pages_, "Markdown files; their commands run in the current folder",
                    "FILE")
            .required();
        options.flag("--check", is_check_,
                     "Write no page and no other file; tell where one is not as its commands "
                     "print it, with exit status 1");
    }

    void read() override {}

    int run() override {
        // A page with a mistake leaves all of them as they were.
        std::vector<RenewedPage> pages;
        for (const std::string& path : pages_)
            pages.push_back(renew_page(path, is_check_, pages_));
        if (is_check_)
            return check(pages);
        write(pages);
        for (const RenewedPage& page : pages)
            print(fmt::format("{}: {}, {} renewed\n", printable(page.page.name),
                              counted(page.commands.size(), "command"),
                              differences_in(page).size()));
        return exit_fine;
    }

private:
    std::vector<std::string> pages_;
    bool is_check_ = false; ///< write nothing, tell what differs
};

} // namespace

std::unique_ptr<Command> renew_command() {
    return std::make_unique<RenewCommand>();
}

} // namespace rastertrace
