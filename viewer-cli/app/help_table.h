// SPDX-License-Identifier: MIT
#pragma once

// What a command says of itself: the one table that the help, the man pages and the completions of shells are made of.
// OptionList fills it while options are added.

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

namespace rastertrace {

/// A word, and what it means.
struct ExplainedWord {
    std::string word;
    std::string meaning;
};

/// What a command is for.
struct CommandAbout {
    std::string name;
    std::string meaning;
    /// Commands to try, a line each; and after a blank line what else is to be said, in paragraphs. Lines that begin with
    /// two blanks stay as they are.
    std::string example;
    /// Words that options take, below a heading at the end.
    std::string words_title = {};
    std::vector<ExplainedWord> words = {};

    /// The commands to try.
    std::vector<std::string> commands() const;

    /// What else is to be said, line by line; the first one is blank.
    std::vector<std::string> remarks() const;
};

/// Where the names are told that an option takes, for completions.
enum class NamesOf : unsigned char {
    nothing,
    primitives, ///< of a scene
    mistakes,
    faces, ///< these and the others are names to ask about, see explain.h
    vertices,
    edges,
    triangles
};

/// An option, or an argument.
struct OptionRow {
    std::string names; ///< "-o,--output"; of an argument, one without dashes
    std::string type;  ///< of its value, as the help shows it: "FILE"; "" if it has none
    std::string meaning;
    std::string group = {}; ///< the heading that it stands below; "" of the command's own
    std::vector<std::string> values = {}; ///< all names that it takes, if they are few
    bool are_values_told = true;          ///< behind its meaning
    NamesOf names_of = NamesOf::nothing;  ///< the names that it takes are of this
    bool is_shared = false;               ///< many commands have it: the short help leaves it out
    bool is_required = false;

    bool is_argument() const { return !names.starts_with('-'); }

    /// "-o" and "--output".
    std::vector<std::string> all_names() const;

    /// What it means, and its values.
    std::string whole_meaning() const;
};

/// Options of which one may be given.
struct OptionGroup {
    std::string title;
    std::string note;
};

struct CommandTable {
    CommandAbout about;
    std::vector<OptionRow> options = {};
    std::vector<OptionGroup> groups = {};

    /// "rastertrace show [OPTIONS] TRACE"
    std::string usage() const;

    /// What is said below a heading; "" if nothing is.
    std::string note_below(std::string_view heading) const;

    /// The headings in the order of the help, "" the first: the command's own, its groups, what many commands have.
    std::vector<std::string> headings() const;

    /// The rows below a heading.
    std::vector<const OptionRow*> rows_below(std::string_view heading) const;
};

/// Commands that belong together.
struct CommandGroup {
    std::string title;
    std::vector<const CommandTable*> commands;
};

/// The table of the command of this name. Throws a Problem if there is none.
const CommandTable& table_of(std::string_view name, const std::vector<CommandGroup>& groups);

/// What `rastertrace show -h` prints, or `--help`, which has what many commands share too. Lines have at most 80 columns.
enum class HelpLength : unsigned char { brief, whole };
std::string help_text(const CommandTable& command, HelpLength length);

/// What `rastertrace --help` prints.
std::string help_text(const std::vector<CommandGroup>& groups);

/// A name, and beside it in lines of at most 80 columns what it means.
std::string help_row(std::string_view name, std::string_view meaning);

/// A command in lines of so many columns at most that a shell takes for one.
std::vector<std::string> command_lines(const std::string& command, std::size_t columns);

/// The page of the manual, section 1, in roff: of a command, or of the program.
std::string man_page(const CommandTable& command);
std::string man_page(const std::vector<CommandGroup>& groups);

} // namespace rastertrace
