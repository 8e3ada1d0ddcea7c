// SPDX-License-Identifier: MIT
#pragma once

// A command of the program as it is typed: its name, its options, and what it does with their
// values. Each stands in the file of its command. Only command_line.cpp knows CLI11.
//
//     void add_to(OptionList& options) override {
//         options.option("scene", command_.scene, "A scene; - for standard input", "SCENE").required();
//         options.flag("--json", command_.json, "Print JSON");
//     }

#include "app/help_table.h"

#include <cstddef>
#include <initializer_list>
#include <memory>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace CLI {
class App;
class Option;
} // namespace CLI

namespace rastertrace {

/// An option of a command, to set its further properties.
class AddedOption {
public:
    AddedOption(CLI::Option& option, CommandTable& table)
        : option_(&option), table_(&table), row_(table.options.size() - 1) {}

    AddedOption& required(bool is_required = true);
    AddedOption& shared(const std::string& title); ///< many commands have it, below this heading
    AddedOption& names_of(NamesOf what);           ///< it takes names of these

    /// It takes these names, which the text of the command tells.
    AddedOption& values_told_below(const std::vector<std::string_view>& names);

    /// It takes these names. The help tells them behind its meaning.
    template <typename Names> AddedOption& values(const Names& names) {
        table_->options[row_].values.assign(std::begin(names), std::end(names));
        return *this;
    }
    AddedOption& values(std::initializer_list<std::string_view> names) {
        table_->options[row_].values.assign(names.begin(), names.end());
        return *this;
    }
    AddedOption& repeatable();          ///< may be given again, with one value each time
    AddedOption& separated_by_commas(); ///< has a list of values
    AddedOption& with_optional_value(); ///< may be given alone
    AddedOption& excludes(AddedOption& other);

    bool is_given() const; ///< with or without a value

private:
    CLI::Option* option_;
    CommandTable* table_;
    std::size_t row_; ///< its place in the table
};

/// The options of a command, to be added to.
class OptionList {
public:
    /// `language` gets the value of --language.
    OptionList(CLI::App& app, std::string& language, CommandTable& table, std::string group = {})
        : app_(&app), language_(&language), table_(&table), group_(std::move(group)) {}

    /// Adds an option, or an argument if its name has no dashes. The help shows `type` behind the
    /// name. `Value` is a text, an optional text or a vector of texts.
    template <typename Value>
    AddedOption option(const std::string& names, Value& value, const std::string& help,
                       const std::string& type);

    /// Adds an option without a value.
    AddedOption flag(const std::string& names, bool& value, const std::string& help);

    /// Adds a list of options of which at most one may be given; exactly one, if `is_required`.
    OptionList one_of(const std::string& title, const std::string& help, bool is_required = false);

    /// Adds --language.
    void language();

private:
    CLI::App* app_;
    std::string* language_;
    CommandTable* table_;
    std::string group_; ///< the heading in the help
};

class Command {
public:
    virtual ~Command() = default;

    virtual CommandAbout about() const = 0;

    virtual void add_to(OptionList& options) = 0;

    /// How many words at the end of the command line are no options, whatever they look like.
    virtual std::size_t count_plain_words(std::span<const char* const>) const { return 0; }

    /// The words behind the command, with what may be left out put in: the value of an option that can do without.
    virtual std::vector<const char*> completed(std::vector<const char*> words) const {
        return words;
    }

    /// Takes these words. Called before the options are read.
    virtual void take_plain_words(std::span<const char* const>) {}

    /// Reads the values of the options. Throws a Problem if one does not fit.
    virtual void read() = 0;

    /// Runs the command; returns the exit status.
    virtual int run() = 0;
};

// The commands.
std::unique_ptr<Command> trace_command();
std::unique_ptr<Command> show_command();
std::unique_ptr<Command> play_command();
std::unique_ptr<Command> figure_command();
std::unique_ptr<Command> explain_command();
std::unique_ptr<Command> stats_command();
std::unique_ptr<Command> check_command();
std::unique_ptr<Command> sheet_command();
std::unique_ptr<Command> diff_command();
std::unique_ptr<Command> validate_command();
std::unique_ptr<Command> plan_command();
std::unique_ptr<Command> fuzz_command();
std::unique_ptr<Command> diagnose_command();
std::unique_ptr<Command> examples_command();
std::unique_ptr<Command> stress_command();
std::unique_ptr<Command> report_command();
std::unique_ptr<Command> renew_command();

/// Explains those of the groups, which may be added after it was made, and must outlive it.
std::unique_ptr<Command> help_command(const std::vector<CommandGroup>& groups);

} // namespace rastertrace
