// SPDX-License-Identifier: MIT
// `rastertrace help`: what a command does, for people, for `man` and for shells; and the conventions.

#include "app/command.h"
#include "app/completion.h"
#include "app/load.h"
#include "app/option_values.h"

#include <rastertrace/trace/text/conventions.h>
#include <rastertrace/trace/text/output.h>
#include <rastertrace/trace/text/text.h>

#include <fmt/core.h>

#include <string>
#include <string_view>
#include <vector>

namespace rastertrace {

namespace {

/// What a row sets of a key; a dash if it does not.
std::string_view value_in(const ConventionRow& row, std::string_view key) {
    for (const auto& [name, value] : row.method)
        if (name == key)
            return value;
    return "-";
}

/// The settings as they stand in a scene: `rows half-open, rounding half-open`.
std::string other_settings(const ConventionRow& row) {
    std::vector<std::string> all;
    for (const auto& [name, value] : row.method)
        if (name != "fill" && name != "sample" && name != "line" && name != "depth")
            all.push_back(fmt::format("{} {}", name, value));
    return all.empty() ? "-" : joined(all, ", ");
}

/// Whose rules a scene can be drawn by, side by side, and what is unusual about them.
std::string conventions_text() {
    const auto line = [](std::string_view name, std::string_view fill, std::string_view sample,
                         std::string_view lines, std::string_view depth, std::string_view others) {
        return fmt::format("{:<13} {:<12} {:<8} {:<13} {:<10} {}\n", name, fill, sample, lines,
                           depth, others);
    };
    std::string text = line("convention", "fill", "sample", "line", "depth", "other keys");
    for (const ConventionRow& row : convention_rows())
        text += line(row.name, value_in(row, "fill"), value_in(row, "sample"),
                     value_in(row, "line"), value_in(row, "depth"), other_settings(row));
    for (const ConventionRow& row : convention_rows())
        text += fmt::format("\n{}: {}\n  viewport  {}\n  source    {}\n  unusual   {}\n", row.name,
                            row.what, name_of_view(row), row.source, row.unusual);
    return text;
}

class HelpCommand final : public Command {
public:
    explicit HelpCommand(const std::vector<CommandGroup>& groups) : groups_(groups) {}

    CommandAbout about() const override {
        return {
            "help", "Explain a command, or the conventions",
            "rastertrace help show\n"
            "rastertrace help conventions\n\n"
            "`help conventions` lists whose rules a scene can be drawn by, and what they set.\n\n"
            "Completions, for the shell that you have:\n"
            "  bash: eval \"$(rastertrace help --completion bash)\"  in ~/.bashrc\n"
            "  zsh:  eval \"$(rastertrace help --completion zsh)\"   in ~/.zshrc\n"
            "  fish: rastertrace help --completion fish | source   in config.fish"};
    }

    void add_to(OptionList& options) override {
        options.option("command", command_,
                       "The command, or conventions; all commands if none is given", "COMMAND");
        options.flag("--man", is_man_, "Print its page of the manual, for man -l -");
        options
            .option("--completion", shell_, "Print what a shell has to read to complete words",
                    "SHELL")
            .values(completed_shells());
    }

    std::size_t count_plain_words(std::span<const char* const> words) const override {
        for (std::size_t i = 0; i < words.size(); ++i)
            if (words[i] == std::string_view("--"))
                return words.size() - i;
        return 0;
    }

    void take_plain_words(std::span<const char* const> words) override {
        completes_ = !words.empty();
        words_.assign(words.begin() + (completes_ ? 1 : 0), words.end());
    }

    void read() override { value_of<std::size_t>("--completion", shell_, completed_shells()); }

    int run() override {
        if (completes_)
            for (const std::string& one : completions(words_, groups_))
                print(one + "\n");
        else if (!shell_.empty())
            print(completion_script(shell_));
        else if (command_.empty())
            print(is_man_ ? man_page(groups_) : help_text(groups_));
        else if (command_ == "conventions" && !is_man_)
            print(conventions_text());
        else if (const CommandTable& table = table_of(command_, groups_); is_man_)
            print(man_page(table));
        else
            print(help_text(table, HelpLength::whole));
        return exit_fine;
    }

private:
    const std::vector<CommandGroup>& groups_;
    std::string command_;
    std::string shell_;
    std::vector<std::string> words_; ///< behind --: a shell asks what the last of them can become
    bool is_man_ = false;
    bool completes_ = false;
};

} // namespace

std::unique_ptr<Command> help_command(const std::vector<CommandGroup>& groups) {
    return std::make_unique<HelpCommand>(groups);
}

} // namespace rastertrace
