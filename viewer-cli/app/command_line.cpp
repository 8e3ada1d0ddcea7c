// SPDX-License-Identifier: MIT
// Reads the command line and runs the command that it names. The only file that knows CLI11.

#include "app/command_line.h"

#include "app/command.h"
#include "app/command_words.h"
#include "app/exit_status.h"
#include "app/installed_files.h"
#include "app/load.h"
#include "app/shared_options.h"
#include "commands/report_file.h"

#include <rastertrace/trace/text/language.h>
#include <rastertrace/trace/text/problem.h>
#include <rastertrace/trace/text/text.h>
#include <rastertrace/wasm/module.h>

#include <CLI/CLI.hpp>
#include <fmt/core.h>

#include <gmp.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <exception>
#include <filesystem>
#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace rastertrace {

AddedOption& AddedOption::required(bool is_required) {
    option_->required(is_required);
    table_->options[row_].is_required = is_required;
    return *this;
}
AddedOption& AddedOption::shared(const std::string& title) {
    table_->options[row_].group = title;
    table_->options[row_].is_shared = true;
    return *this;
}
AddedOption& AddedOption::values_told_below(const std::vector<std::string_view>& names) {
    table_->options[row_].are_values_told = false;
    return values(names);
}
AddedOption& AddedOption::names_of(NamesOf what) {
    table_->options[row_].names_of = what;
    return *this;
}
AddedOption& AddedOption::repeatable() {
    option_->take_all()->allow_extra_args(false);
    return *this;
}
AddedOption& AddedOption::separated_by_commas() {
    option_->delimiter(',')->allow_extra_args(false);
    return *this;
}
AddedOption& AddedOption::with_optional_value() {
    option_->expected(0, 1);
    return *this;
}
AddedOption& AddedOption::excludes(AddedOption& other) {
    option_->excludes(other.option_);
    return *this;
}
bool AddedOption::is_given() const {
    return option_->count() > 0;
}

template <typename Value>
AddedOption OptionList::option(const std::string& names, Value& value, const std::string& help,
                               const std::string& type) {
    table_->options.push_back({.names = names, .type = type, .meaning = help, .group = group_});
    return {*app_->add_option(names, value), *table_};
}
template AddedOption OptionList::option(const std::string&, std::string&, const std::string&,
                                        const std::string&);
template AddedOption OptionList::option(const std::string&, std::optional<std::string>&,
                                        const std::string&, const std::string&);
template AddedOption OptionList::option(const std::string&, std::vector<std::string>&,
                                        const std::string&, const std::string&);

AddedOption OptionList::flag(const std::string& names, bool& value, const std::string& help) {
    table_->options.push_back({.names = names, .type = {}, .meaning = help, .group = group_});
    return {*app_->add_flag(names, value), *table_};
}
OptionList OptionList::one_of(const std::string& title, const std::string& help, bool is_required) {
    CLI::Option_group* const group = app_->add_option_group(title, help);
    group->require_option(is_required ? 1 : 0, 1);
    table_->groups.push_back({title, help});
    return {*group, *language_, *table_, title};
}
void OptionList::language() {
    option("--language", *language_,
           "Tell steps in this language; what RASTERTRACE_LANGUAGE says if not given", "CODE")
        .values(language_codes());
}

namespace {

/// Commands that belong together, in the order of the help.
struct MakersOfGroup {
    std::string_view title;
    std::vector<std::unique_ptr<Command> (*)()> makers;
};
const std::array<MakersOfGroup, 5> command_groups{
    {{"Draw and look",
      {trace_command, show_command, play_command, figure_command, explain_command, stats_command}},
     {"Work by hand", {check_command, sheet_command}},
     {"Test a renderer", {diff_command, diagnose_command, fuzz_command}},
     {"Error and time", {stress_command, report_command}},
     {"Files and pages", {validate_command, plan_command, examples_command, renew_command}}}};

bool has_word(std::span<const char* const> words, std::string_view word) {
    return std::ranges::find(words, word) != words.end();
}

std::string place_of_examples() {
    try {
        return examples_folder().string();
    } catch (const Problem&) {
        return "none found";
    }
}

/// What `--version` prints; with `--verbose` also how the program was built, and what it finds.
std::string version_text(bool is_verbose) {
    const std::string text = fmt::format("rastertrace {}\n", RASTERTRACE_VERSION);
    if (!is_verbose)
        return text;
    const Machine machine = this_machine();
    return text + fmt::format("  compiler  {}\n  flags     {}\n  packages  GMP {}, fmt {}.{}.{}\n"
                              "  pages     {}\n  examples  {}\n",
                              machine.compiler, machine.flags, gmp_version, FMT_VERSION / 10000,
                              FMT_VERSION / 100 % 100, FMT_VERSION % 100,
                              wasm_module().empty()
                                  ? "show what was drawn: built without RASTERTRACE_WASM"
                                  : "draw by themselves, with the arithmetic of this program",
                              place_of_examples());
}

/// The program: its commands, the one that is run, and messages about how it was called.
class Program {
public:
    Program() {
        app_.require_subcommand(1);
        app_.set_help_flag("-h,--help");
        CLI::Option* const version = app_.set_version_flag("-V,--version", RASTERTRACE_VERSION);
        app_.add_flag("--verbose")->needs(version);
        for (const auto& [title, makers] : command_groups) {
            CommandGroup& group = groups_.emplace_back(CommandGroup{std::string(title), {}});
            for (const auto make : makers)
                group.commands.push_back(&add(make()));
        }
        groups_.back().commands.push_back(&add(help_command(groups_)));
    }

    int run(int count, const char* const* arguments) {
        if (count < 2) {
            print_error(welcome);
            return exit_bad_input;
        }
        std::vector<const char*> words = words_with_command({arguments, arguments + count});
        Command* const command = command_named(words[1]);
        if (command != nullptr) {
            const auto behind_name = std::span(words).subspan(2);
            const auto plain = behind_name.last(command->count_plain_words(behind_name));
            command->take_plain_words(plain);
            words.resize(words.size() - plain.size());
            words = command->completed(std::move(words));
        }
        try {
            refuse_empty_words(words);
            if (!std::string_view(words[1]).starts_with('-'))
                table_of(words[1], groups_); // throws if there is none
            app_.parse(static_cast<int>(words.size()), words.data());
            return run_chosen(words);
        } catch (const CLI::CallForHelp&) {
            print_help(words);
        } catch (const CLI::CallForVersion&) {
            print(version_text(has_word(words, "--verbose")));
        } catch (const CLI::ParseError& error) {
            return complain(error, words);
        }
        return exit_fine;
    }

private:
    const CommandTable& add(std::unique_ptr<Command> command) {
        const CommandAbout about = command->about();
        CommandTable& table = tables_[about.name];
        table.about = about;
        OptionList options(*app_.add_subcommand(about.name), language_, table);
        command->add_to(options);
        commands_.emplace(about.name, std::move(command));
        return table;
    }

    /// The command of this name; nullptr of what is none.
    Command* command_named(std::string_view name) const {
        const auto found = commands_.find(name);
        return found == commands_.end() ? nullptr : found->second.get();
    }

    int run_chosen(std::span<const char* const> words) {
        Command& command = *command_named(chosen().get_name());
        if (::isatty(STDIN_FILENO) != 0 && reads_standard_input(words))
            print_error("rastertrace: reading what you type; Ctrl-D on an empty line ends it\n");
        command.read();
        choose_language(language_);
        return command.run();
    }

    /// What was asked by -h or --help.
    void print_help(std::span<const char* const> words) const {
        const bool is_whole = has_word(words, "--help");
        if (&chosen() == &app_)
            print(help_text(groups_));
        else
            print(help_text(table_of(chosen().get_name(), groups_),
                            is_whole ? HelpLength::whole : HelpLength::brief));
    }

    /// The command that was named, or the program as a whole.
    const CLI::App& chosen() const {
        const auto commands = app_.get_subcommands();
        return commands.empty() ? app_ : *commands.front();
    }

    /// Says what CLI11 could not read.
    int complain(const CLI::ParseError& error, std::span<const char* const> words) const {
        const CLI::App& command = chosen();
        std::vector<std::string> options{"--help"};
        if (&command == &app_)
            options.insert(options.end(), {"--version", "--verbose"});
        if (const auto table = tables_.find(command.get_name()); table != tables_.end())
            for (const OptionRow& row : table->second.options)
                for (const std::string& name : row.all_names())
                    if (name.starts_with("--"))
                        options.push_back(name);
        Complaint complaint = unknown_option(words, options).value_or(Complaint{error.what(), ""});
        if (complaint.hint.empty() &&
            error.get_exit_code() == static_cast<int>(CLI::ExitCodes::ExtrasError) &&
            have_condition(words))
            complaint.hint = R"(a step of several words goes in quotes: "scanline y=2")";
        const std::string hint =
            complaint.hint.empty() ? "" : fmt::format("hint: {}\n", printable(complaint.hint));
        const std::string name =
            &command == &app_ ? "rastertrace" : "rastertrace " + command.get_name();
        print_error(fmt::format("{}: {}\n{}see {} --help\n", name, printable(complaint.message),
                                hint, name));
        return exit_bad_input;
    }

    CLI::App app_{"A rasterizer you can watch think", "rastertrace"};
    std::map<std::string, std::unique_ptr<Command>, std::less<>> commands_; ///< by their names
    std::map<std::string, CommandTable> tables_;                            ///< the same
    std::vector<CommandGroup> groups_;                                      ///< of the help
    std::string language_;
};

} // namespace

int run_command_line(int count, const char* const* arguments) noexcept {
    try {
        try {
            Program program;
            return program.run(count, arguments);
        } catch (Problem& problem) {
            std::error_code error;
            if (problem.hint.empty() && problem.file.starts_with("examples/") &&
                !std::filesystem::exists("examples", error))
                problem.hint = "rastertrace examples -o examples copies the examples";
            print_error(problem);
            return problem.cause == Problem::Cause::system ? exit_system : exit_bad_input;
        }
    } catch (const std::exception& failure) {
        // What the C++ library cannot do; no input should lead here.
        print_error("rastertrace: ");
        print_error(failure.what());
        print_error("\n");
        return exit_system;
    }
}

} // namespace rastertrace
