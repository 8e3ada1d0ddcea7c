// SPDX-License-Identifier: MIT
#include "app/help_table.h"

#include "app/command_words.h"

#include <rastertrace/trace/text/problem.h>
#include <rastertrace/trace/text/text.h>

#include <fmt/core.h>

#include <algorithm>

namespace rastertrace {

namespace {

constexpr std::size_t widest_line = 80;
constexpr std::size_t indent = 2;
constexpr std::size_t meaning_column = 24;

std::string indented(const std::vector<std::string>& lines, std::size_t columns) {
    std::string text;
    for (const std::string& line : lines)
        text += fmt::format("{:{}}{}\n", "", columns, line);
    return text;
}

std::string example(const std::string& command) {
    return indented(command_lines(command, widest_line - indent), indent);
}

/// What stands behind the examples, in lines of at most 80 columns.
std::string paragraphs(const std::vector<std::string>& lines) {
    std::string text;
    std::string paragraph;
    const auto end_paragraph = [&] {
        text += indented(wrapped(paragraph, widest_line), 0);
        paragraph.clear();
    };
    for (const std::string& line : lines) {
        if (!line.empty() && !line.starts_with("  ")) {
            paragraph += (paragraph.empty() ? "" : " ") + line;
            continue;
        }
        end_paragraph();
        text += line + "\n";
    }
    end_paragraph();
    return text;
}

/// "-o, --output FILE", or "TRACE".
std::string shown_name(const OptionRow& row) {
    if (row.is_argument())
        return row.type;
    return joined(row.all_names(), ", ") + (row.type.empty() ? "" : " " + row.type);
}

std::string rows_text(const std::vector<const OptionRow*>& rows) {
    std::string text;
    for (const OptionRow* row : rows)
        text += help_row(shown_name(*row), row->whole_meaning());
    return text;
}

} // namespace

std::vector<std::string> CommandAbout::commands() const {
    std::vector<std::string> commands;
    for (const std::string& line : split_at(example.substr(0, example.find("\n\n")), '\n'))
        commands.emplace_back(without_blanks(line));
    return commands;
}

std::vector<std::string> CommandAbout::remarks() const {
    const std::size_t behind = example.find("\n\n");
    return behind == std::string::npos ? std::vector<std::string>()
                                       : split_at(example.substr(behind + 1), '\n');
}

std::string CommandTable::note_below(std::string_view heading) const {
    const auto group = std::ranges::find(groups, heading, &OptionGroup::title);
    return group == groups.end() ? std::string() : group->note;
}

std::vector<std::string> OptionRow::all_names() const {
    return split_at(names, ',');
}

std::string OptionRow::whole_meaning() const {
    return values.empty() || !are_values_told
               ? meaning
               : fmt::format("{} ({})", meaning, joined(values, ", "));
}

std::string CommandTable::usage() const {
    std::string text = "rastertrace " + about.name + " [OPTIONS]";
    for (const OptionRow& row : options)
        if (row.is_argument())
            text += row.is_required ? " " + row.type : fmt::format(" [{}]", row.type);
        else if (row.is_required)
            text += fmt::format(" {} {}", row.all_names().front(), row.type);
    return text;
}

std::vector<std::string> CommandTable::headings() const {
    std::vector<std::string> all{""};
    for (const bool is_shared : {false, true})
        for (const OptionRow& row : options)
            if (row.is_shared == is_shared &&
                std::find(all.begin(), all.end(), row.group) == all.end())
                all.push_back(row.group);
    return all;
}

std::vector<const OptionRow*> CommandTable::rows_below(std::string_view heading) const {
    std::vector<const OptionRow*> rows;
    for (const OptionRow& row : options)
        if (row.group == heading)
            rows.push_back(&row);
    // Arguments first.
    std::stable_partition(rows.begin(), rows.end(),
                          [](const OptionRow* row) { return row->is_argument(); });
    return rows;
}

const CommandTable& table_of(std::string_view name, const std::vector<CommandGroup>& groups) {
    std::vector<std::string_view> names;
    for (const CommandGroup& group : groups)
        for (const CommandTable* command : group.commands) {
            if (command->about.name == name)
                return *command;
            names.push_back(command->about.name);
        }
    throw problem_of(
        "", fmt::format("expected a command out of {}, found \"{}\"", joined(names, ", "), name),
        did_you_mean(name, names));
}

std::vector<std::string> command_lines(const std::string& command, std::size_t columns) {
    const std::string continued = " \\";
    auto lines = wrapped(command, columns - continued.size());
    for (std::size_t i = 0; i + 1 < lines.size(); ++i)
        lines[i] += continued;
    for (std::size_t i = 1; i < lines.size(); ++i)
        lines[i].insert(0, "  ");
    return lines;
}

std::string help_row(std::string_view name, std::string_view meaning) {
    const std::size_t column = indent + columns_in(name) + indent;
    const auto lines = wrapped(meaning, widest_line - meaning_column);
    std::string text = fmt::format("{:{}}{}", "", indent, name);
    if (column > meaning_column)
        return text + "\n" + indented(lines, meaning_column);
    return text + indented(lines, meaning_column).substr(indent + columns_in(name));
}

std::string help_text(const CommandTable& command, HelpLength length) {
    const CommandAbout& about = command.about;
    std::string text = fmt::format("{}\nUsage: {}\n", paragraphs({about.meaning}), command.usage());
    std::vector<std::string> left_out;
    for (const std::string& heading : command.headings()) {
        const auto rows = command.rows_below(heading);
        if (length == HelpLength::brief && !rows.empty() && rows.front()->is_shared) {
            left_out.push_back(fmt::format("{} ({})", heading, rows.size()));
            continue;
        }
        if (heading.empty()) {
            text += "\n" + rows_text(rows) +
                    help_row("-h, --help", "Print this help; --help has all options");
            continue;
        }
        text += fmt::format("\n{}:\n", heading);
        if (const std::string note = command.note_below(heading); !note.empty())
            text += indented(wrapped(note + ":", widest_line - indent), indent);
        text += rows_text(rows);
    }
    if (!left_out.empty())
        text += "\n" + paragraphs({"More with --help: " + joined(left_out, "; ") + "."});
    text += "\nExample:\n";
    for (const std::string& tried : about.commands())
        text += example(tried);
    text += paragraphs(about.remarks());
    if (!about.words.empty())
        text += fmt::format("\n{}:\n", about.words_title);
    for (const auto& [word, meaning] : about.words)
        text += help_row(word, meaning);
    return text;
}

std::string help_text(const std::vector<CommandGroup>& groups) {
    std::string text = "A rasterizer you can watch think\n\nUsage: rastertrace COMMAND [OPTIONS]\n";
    for (const CommandGroup& group : groups) {
        text += fmt::format("\n{}:\n", group.title);
        for (const CommandTable* command : group.commands)
            text += help_row(command->about.name, command->about.meaning);
    }
    text += "\n" + help_row("-h, --help", "Print this help; of a command, --help has all options") +
            help_row("-V, --version",
                     "Print the version; with --verbose also how the program was built");
    text += "\nExample:\n" + example("rastertrace examples -o examples") +
            example("rastertrace show examples/t0-fill/first-triangle.json");
    return text + "\n" +
           paragraphs({"A file without a command is shown. " + std::string(exit_statuses)});
}

} // namespace rastertrace
