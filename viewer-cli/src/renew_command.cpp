// SPDX-License-Identifier: MIT
// `rastertrace renew`: the commands on Markdown pages, run again.

#include "command.h"
#include "commands.h"
#include "load.h"
#include "option_values.h"
#include "page.h"
#include "page_files.h"
#include "run_self.h"

#include <rastertrace/core/draw/plan/stages.h>
#include <rastertrace/trace/text/input.h>
#include <rastertrace/trace/text/output.h>
#include <rastertrace/trace/text/process_files.h>
#include <rastertrace/trace/text/text.h>

#include <fmt/core.h>

#include <algorithm>
#include <chrono>
#include <cstddef>
#include <filesystem>
#include <memory>
#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <system_error>
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

/// The folder of a page, if it has a file that a command names and that the current folder does not have; else "".
std::string folder_of_files(const Source& page, const PageCommand& command) {
    namespace fs = std::filesystem;
    const fs::path folder = fs::path(page.name).parent_path();
    std::error_code ignored;
    const bool has_files =
        std::any_of(command.words.begin(), command.words.end(), [&](const std::string& word) {
            return !folder.empty() && fs::is_regular_file(folder / word, ignored) &&
                   !fs::exists(word, ignored);
        });
    return has_files ? folder.string() : std::string();
}

/// A command that ended otherwise than its page says.
Problem problem_of_exit(const Source& page, const PageCommand& command, const FinishedRun& run) {
    const bool has_to_succeed = command.exit_status == 0;
    std::string hint;
    if (const auto folder = folder_of_files(page, command); !folder.empty())
        hint = fmt::format("commands run in the current folder: cd {} before renew", folder);
    else if (!run.err.empty())
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

bool is_command(const PageCommand& command, std::string_view name) {
    return !command.words.empty() && command.words.front() == name;
}

/// Runs a command; returns its output for the page.
std::string output_of(const Source& page, const PageCommand& command, const RunLimits& limits) {
    if (is_command(command, "renew"))
        throw problem_at(page, command.begin,
                         "expected a command that shows something, found renew");

    const FinishedRun run = run_self(command.words, limits);
    if (run.is_too_long)
        throw problem_at(page, command.begin,
                         fmt::format("expected a command that ends within {} s, found one that "
                                     "takes longer",
                                     limits.time.count()),
                         "renew --timeout SECONDS gives it more time");
    if (run.is_too_large)
        throw problem_at(page, command.begin,
                         fmt::format("expected a command that prints at most {} MB, found more",
                                     most_output / 1'000'000));
    if (run.exit_status != command.exit_status)
        throw problem_of_exit(page, command, run);
    return output_for(page, command, run.out + run.err);
}

/// What commands on pages may do.
RunLimits limits_of(const RenewCommand& command) {
    RunLimits limits{.files = {}, .time = command.time};
    if (command.allow_outside)
        return limits;
    std::error_code error;
    limits.files.below = std::filesystem::canonical(".", error).string();
    if (error)
        throw problem_of_system("", "the current folder could not be found", error.value());
    return limits;
}

/// Runs the commands of a page. One that is only checked leaves all files as they are.
RenewedPage renew_page(const std::string& path, bool is_checked, RunLimits limits) {
    RenewedPage renewed{.page = load_page(path),
                        .commands = {},
                        .outputs = {},
                        .stale_files = {},
                        .written_files = {},
                        .left_over = {}};
    renewed.commands = commands_on(renewed.page);
    for (const PageCommand& command : renewed.commands) {
        if (!is_checked) {
            renewed.outputs.push_back(output_of(renewed.page, command, limits));
            continue;
        }
        const EndingHeldBack until_removed;
        const OutputsElsewhere elsewhere;
        limits.files.outputs = elsewhere.folder();
        renewed.outputs.push_back(output_of(renewed.page, command, limits));
        if (is_command(command, "report")) // its times are never the same
            continue;
        for (const std::string& file : elsewhere.stale_files())
            renewed.stale_files.push_back(problem_at(
                renewed.page, command.begin,
                fmt::format("expected {} as this command writes it, found another file, or none",
                            printable(file))));
        for (const std::string& file : elsewhere.left_over_files(command.words))
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

/// Throws a Problem if a page is no longer as it was read: what somebody has typed meanwhile would be lost.
void look_again(const Source& page) {
    const auto now = read_named_file(page.name, {});
    std::string_view found;
    if (!now)
        found = "none that can be read any more";
    else if (now.value().text != page.text)
        found = "it changed meanwhile";
    else if (now.value().file != page.file)
        found = "another file in its place";
    else
        return;
    throw problem_of(page.name, fmt::format("expected the page that was read, found {}", found),
                     "no page was written; renew PAGE -o FILE writes what its commands print now "
                     "to another file");
}

/// Writes the pages that are stale: all of them, or none.
void write(const std::vector<RenewedPage>& pages) {
    FileOutputs outputs;
    std::vector<const Source*> written;
    for (const RenewedPage& page : pages) {
        const bool is_known =
            std::any_of(written.begin(), written.end(),
                        [&page](const Source* other) { return other->file == page.page.file; });
        if (is_known || differences_in(page).empty())
            continue;
        outputs.open(page.page.name).write(with_outputs(page.page, page.commands, page.outputs));
        written.push_back(&page.page);
    }
    for (const Source* const page : written)
        look_again(*page);
    outputs.commit();
}

} // namespace

int run(const RenewCommand& command) {
    // A page with a mistake leaves all of them as they were.
    std::vector<RenewedPage> pages;
    for (const std::string& path : command.pages)
        pages.push_back(renew_page(path, command.check, limits_of(command)));

    if (command.check)
        return check(pages);
    if (command.output.empty()) {
        write(pages);
    } else {
        const RenewedPage& page = pages.front();
        write_file(command.output, with_outputs(page.page, page.commands, page.outputs),
                   opened_files());
    }
    for (const RenewedPage& page : pages)
        print(fmt::format("{}: {}, {} renewed\n", printable(page.page.name),
                          counted(page.commands.size(), "command"), differences_in(page).size()));
    return exit_fine;
}

namespace {

class RenewCommandLine final : public Command {
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
            .option("page", command_.pages,
                    "Markdown files; their commands run in the current folder", "FILE")
            .required();
        options.option("-o,--output", command_.output,
                       "Write the only page to this file, and leave it as it is", "FILE");
        options.flag("--check", command_.check,
                     "Write no page and no other file; tell where one is not as its commands "
                     "print it, with exit status 1");
        options.flag("--allow-outside", command_.allow_outside,
                     "Let commands read and write files outside of the current folder too: "
                     "only for pages that you trust");
        options.option("--timeout", time_, "Seconds that a command may take, 60 if not given",
                       "SECONDS");
    }

    void read() override {
        for (const std::string& page : command_.pages)
            if (page == "-")
                refuse_value("renew", "the names of pages", page);
        if (command_.output == "-")
            refuse_value("--output", "the name of a file", "-");
        if (!command_.output.empty() && (command_.check || command_.pages.size() > 1))
            refuse_value("--output", "one page, and no --check", command_.output);
        if (const auto seconds =
                number_in_option("--timeout", time_, 1, 1'000'000, "a number of seconds"))
            command_.time = std::chrono::seconds(*seconds);
    }

    int run() override { return rastertrace::run(command_); }

private:
    RenewCommand command_;
    std::string time_;
};

} // namespace

std::unique_ptr<Command> renew_command() {
    return std::make_unique<RenewCommandLine>();
}

} // namespace rastertrace
