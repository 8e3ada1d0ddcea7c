// SPDX-License-Identifier: MIT
// Reads the command line and runs the command that it names. The only file that knows CLI11.

#include "command_line.h"

#include "command.h"
#include "command_words.h"
#include "commands.h"
#include "load.h"
#include "shared_options.h"

#include <rastertrace/trace/text/language.h>
#include <rastertrace/trace/text/problem.h>
#include <rastertrace/trace/text/text.h>

#include <CLI/CLI.hpp>
#include <fmt/core.h>

#include <algorithm>
#include <exception>
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
    return *this;
}
AddedOption& AddedOption::group(const std::string& title) {
    option_->group(title);
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
    return AddedOption(*app_->add_option(names, value, help)->type_name(type));
}
template AddedOption OptionList::option(const std::string&, std::string&, const std::string&,
                                        const std::string&);
template AddedOption OptionList::option(const std::string&, std::optional<std::string>&,
                                        const std::string&, const std::string&);
template AddedOption OptionList::option(const std::string&, std::vector<std::string>&,
                                        const std::string&, const std::string&);

AddedOption OptionList::flag(const std::string& names, bool& value, const std::string& help) {
    return AddedOption(*app_->add_flag(names, value, help));
}
OptionList OptionList::one_of(const std::string& title, const std::string& help, bool is_required) {
    CLI::Option_group* const group = app_->add_option_group(title, help);
    group->require_option(is_required ? 1 : 0, 1);
    return {*group, *language_};
}
void OptionList::language() {
    option(
        "--language", *language_,
        fmt::format("Tell steps in this language: {}; what RASTERTRACE_LANGUAGE says if not given",
                    joined(language_codes(), ", ")),
        "CODE");
}

namespace {

/// The program: its commands, the one that is run, and messages about how it was called.
class Program {
public:
    Program() {
        app_.require_subcommand(1);
        app_.set_help_flag("-h,--help", "Print this help and exit");
        app_.set_version_flag("-V,--version", std::string("rastertrace ") + RASTERTRACE_VERSION);
        app_.footer("Example: rastertrace show examples/t0-fill/first-triangle.json\n"
                    "A file without a command is shown.\n" +
                    std::string(exit_statuses));
        for (const auto make :
             {trace_command,    show_command,   play_command,        figure_command,
              explain_command,  stats_command,  check_command,       sheet_command,
              exercise_command, diff_command,   validate_command,    plan_command,
              fuzz_command,     review_command, diagnose_command,    tell_apart_command,
              mistakes_command, scene_command,  conventions_command, stress_command,
              report_command,   renew_command}) {
            std::unique_ptr<Command> command = make();
            const CommandAbout about = command->about();
            CLI::App& app = *app_.add_subcommand(about.name, about.meaning);
            app.footer("Example: " + about.example);
            OptionList options(app, language_);
            command->add_to(options);
            commands_.emplace(about.name, std::move(command));
        }
        CLI::App& help = *app_.add_subcommand("help", "Explain a command");
        help.footer("Example: rastertrace help show");
        help.add_option("command", help_about_, "The command")->type_name("COMMAND");
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
            refuse_unknown_command(words[1]);
            app_.parse(static_cast<int>(words.size()), words.data());
            return run_chosen();
        } catch (const CLI::CallForHelp&) {
            print_help(chosen());
        } catch (const CLI::CallForVersion&) {
            print(fmt::format("rastertrace {}\n", RASTERTRACE_VERSION));
        } catch (const CLI::ParseError& error) {
            return complain(error, words);
        }
        return exit_fine;
    }

private:
    /// The command of this name; none of `help` and of what is no command.
    Command* command_named(std::string_view name) const {
        const auto found = commands_.find(name);
        return found == commands_.end() ? nullptr : found->second.get();
    }

    int run_chosen() {
        Command* const command = command_named(chosen().get_name());
        if (command != nullptr)
            command->read();
        choose_language(language_);
        return command != nullptr ? command->run() : explain();
    }

    /// `help`
    int explain() const {
        if (help_about_.empty()) {
            print_help(app_);
            return exit_fine;
        }
        refuse_unknown_command(help_about_);
        print_help(*app_.get_subcommand(help_about_));
        return exit_fine;
    }

    void print_help(const CLI::App& command) const {
        print(command.help(&command == &app_ ? "" : app_.get_name()));
    }

    /// The command that was named, or the program as a whole.
    const CLI::App& chosen() const {
        const auto commands = app_.get_subcommands();
        return commands.empty() ? app_ : *commands.front();
    }

    void refuse_unknown_command(std::string_view word) const {
        std::vector<std::string> names;
        for (const CLI::App* command : app_.get_subcommands({}))
            names.push_back(command->get_name());
        if (word.starts_with('-') || std::find(names.begin(), names.end(), word) != names.end())
            return;
        throw problem_of(
            "",
            fmt::format("expected a command out of {}, found \"{}\"", joined(names, ", "), word),
            did_you_mean(word, {names.begin(), names.end()}));
    }

    /// Says what CLI11 could not read.
    int complain(const CLI::ParseError& error, std::span<const char* const> words) const {
        const CLI::App& command = chosen();
        std::vector<std::string> options;
        const auto add_options_of = [&options](const CLI::App& list) {
            for (const CLI::Option* option : list.get_options())
                for (const std::string& name : option->get_lnames())
                    options.push_back("--" + name);
        };
        add_options_of(command);
        for (const CLI::App* group : command.get_subcommands({}))
            add_options_of(*group);
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
    std::string language_;
    std::string help_about_;
};

} // namespace

int run_command_line(int count, const char* const* arguments) noexcept {
    try {
        try {
            Program program;
            return program.run(count, arguments);
        } catch (const Problem& problem) {
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
