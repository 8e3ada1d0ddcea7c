// SPDX-License-Identifier: MIT
#include "app/help_table.h"

#include "app/command_words.h"

#include <rastertrace/trace/text/text.h>

#include <fmt/core.h>

#include <algorithm>

namespace rastertrace {

namespace {

/// A page of 80 columns has so many behind the margin.
constexpr std::size_t columns_of_text = 73;

/// A line of text as roff takes it: dashes are those of options, and no line is a command.
std::string roff(std::string_view text) {
    std::string line;
    for (const char c : text)
        line += c == '\\' ? "\\e" : c == '-' ? "\\-" : std::string(1, c);
    return (line.starts_with('.') || line.starts_with('\'') ? "\\&" : "") + line;
}

std::string heading(std::string_view name, std::string_view meaning) {
    std::string upper(name);
    std::transform(upper.begin(), upper.end(), upper.begin(), [](char c) {
        return 'a' <= c && c <= 'z' ? static_cast<char>(c - 'a' + 'A') : c;
    });
    // Names of options and values are not hyphenated.
    return fmt::format(".TH {} 1 \"\" \"rastertrace {}\"\n.nh\n.SH NAME\n{} \\- {}\n", roff(upper),
                       RASTERTRACE_VERSION, roff(name), roff(meaning));
}

/// A term in bold, and what it means.
std::string entry(std::string_view term, std::string_view type, std::string_view meaning) {
    return fmt::format(".TP\n\\fB{}\\fR{}\n{}\n", roff(term),
                       type.empty() ? "" : fmt::format(" \\fI{}\\fR", roff(type)), roff(meaning));
}

/// Lines as they stand.
std::string as_typed(const std::vector<std::string>& lines) {
    std::string text = ".nf\n";
    for (const std::string& line : lines)
        text += roff(line) + "\n";
    return text + ".fi\n";
}

std::string end_of(std::string_view others) {
    return fmt::format(".SH EXIT STATUS\n{}\n.SH SEE ALSO\n{}\n",
                       roff(exit_statuses.substr(exit_statuses.find(':') + 2)), others);
}

} // namespace

std::string man_page(const CommandTable& command) {
    const CommandAbout& about = command.about;
    std::string text = heading("rastertrace-" + about.name, about.meaning) + ".SH SYNOPSIS\n" +
                       roff(command.usage()) + "\n";
    text += ".SH DESCRIPTION\n" + roff(about.meaning) + ".\n";
    for (const std::string& line : about.remarks())
        text += line.empty()             ? ".PP\n"
                : line.starts_with("  ") ? as_typed({line})
                                         : roff(line) + "\n";
    for (const std::string& title : command.headings()) {
        const auto rows = command.rows_below(title);
        if (title.empty())
            text += ".SH OPTIONS\n";
        else
            text += fmt::format(".SS {}\n", roff(title));
        if (const std::string note = command.note_below(title); !note.empty())
            text += roff(note) + "\n";
        for (const OptionRow* row : rows)
            text += row->is_argument()
                        ? entry(row->type, "", row->whole_meaning())
                        : entry(joined(row->all_names(), ", "), row->type, row->whole_meaning());
    }
    if (!about.words.empty())
        text += fmt::format(".SS {}\n", roff(about.words_title));
    for (const auto& [word, meaning] : about.words)
        text += entry(word, "", meaning);
    text += ".SH EXAMPLES\n";
    for (const std::string& tried : about.commands())
        text += as_typed(command_lines(tried, columns_of_text));
    return text + end_of("\\fBrastertrace\\fR(1)");
}

std::string man_page(const std::vector<CommandGroup>& groups) {
    std::string text =
        heading("rastertrace", "a rasterizer you can watch think") +
        ".SH SYNOPSIS\nrastertrace \\fICOMMAND\\fR [OPTIONS]\n"
        ".SH DESCRIPTION\nIt draws a scene with the algorithm of the textbook, writes "
        "down every decision with the numbers that made it, and shows them. A file "
        "without a command is shown.\n";
    std::string others;
    for (const CommandGroup& group : groups) {
        text += fmt::format(".SS {}\n", roff(group.title));
        for (const CommandTable* command : group.commands) {
            text += entry(command->about.name, "", command->about.meaning);
            others += fmt::format("{}\\fB{}\\fR(1)", others.empty() ? "" : ", ",
                                  roff("rastertrace-" + command->about.name));
        }
    }
    text +=
        ".SH OPTIONS\n" +
        entry("-h, --help", "", "Print the help; of a command, --help has all options") +
        entry("-V, --version", "", "Print the version; with --verbose also how it was built") +
        ".SH ENVIRONMENT\n" +
        entry("RASTERTRACE_LANGUAGE", "", "The language that steps are told in, as --language") +
        entry("RASTERTRACE_MODULE", "",
              "The file with the module that lets pages draw, rastertrace.js, instead of the "
              "program's") +
        ".SH FILES\n" +
        entry("share/rastertrace/examples", "",
              "Scenes, claims and traces; rastertrace examples lists and copies them") +
        entry("share/rastertrace/schemas", "", "JSON schemas, for editors") +
        entry("share/rastertrace/rastertrace.py", "", "The module for Python") +
        entry("share/doc/rastertrace", "", "The documentation") + ".SH EXAMPLES\n" +
        as_typed({"rastertrace examples -o examples",
                  "rastertrace play examples/t0-fill/first-triangle.json"});
    return text + end_of(others);
}

} // namespace rastertrace
