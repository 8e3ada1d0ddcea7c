// SPDX-License-Identifier: MIT
#include "app/page.h"

#include "app/option_values.h"

#include <rastertrace/trace/text/text.h>

#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <optional>
#include <utility>

namespace rastertrace {

namespace {

constexpr std::string_view blanks = " \t";
constexpr std::string_view prompt = "$ ";
constexpr std::string_view our_prompt = "$ rastertrace ";

/// What a shell acts on unless it is quoted: what POSIX lists, and what bash adds to that.
constexpr std::string_view needs_shell = "\\|&;<>()$`*?[]{}~!";

bool is_blank(std::string_view text) {
    return text.find_first_not_of(blanks) == std::string_view::npos;
}

/// The fence that a line is, if it has no text; it may be indented by any number of blanks, as in the items of a list.
std::optional<Fence> fence_in(std::string_view line) {
    const std::size_t begin = std::min(line.find_first_not_of(blanks), line.size());
    const std::size_t end = std::min(line.find_first_not_of('`', begin), line.size());
    // ```So``` is code within a line of text.
    if (end - begin < 3 || line.find('`', end) != std::string_view::npos)
        return std::nullopt;
    return Fence{.indent = std::string(line.substr(0, begin)), .length = end - begin};
}

/// True for the line that ends a block: as many marks or more, and nothing behind them.
bool closes(const Fence& fence, std::string_view line) {
    const auto closing = fence_in(line);
    return closing && closing->length >= fence.length && is_blank(line.substr(line.rfind('`') + 1));
}

/// True of a player, which a reader begins; what it prints or lists without one, or refuses, is an output like any other.
bool needs_terminal(std::string_view command) {
    constexpr std::array outputs{" --print", " --keys", " --help", " -h", "# exit"};
    return command.starts_with("$ rastertrace play ") &&
           std::none_of(outputs.begin(), outputs.end(), [command](std::string_view output) {
               return command.find(output) != std::string_view::npos;
           });
}

/// The exit status that a comment states: `exit 2`; 0 of any other comment.
int exit_status_in(std::string_view comment) {
    constexpr std::string_view exit = "exit ";
    const std::size_t begin = std::min(comment.find_first_not_of(blanks), comment.size());
    comment = comment.substr(begin, comment.find_last_not_of(blanks) + 1 - begin);
    return comment.starts_with(exit)
               ? whole_number<std::uint8_t>(comment.substr(exit.size())).value_or(0)
               : 0;
}

/// Reads the words of a command, from a place on the page to the end of its line: quotes are taken away, and a comment
/// may state its exit status.
void read_words(const Source& page, std::size_t at, std::size_t end, PageCommand& command) {
    const std::string_view text = std::string_view(page.text).substr(0, end);
    while ((at = std::min(text.find_first_not_of(blanks, at), end)) < end) {
        if (text[at] == '#') {
            command.exit_status = exit_status_in(text.substr(at + 1));
            return;
        }
        std::string& word = command.words.emplace_back();
        for (; at < end && !is_blank(text.substr(at, 1)); ++at) {
            if (text[at] == '\'' || text[at] == '"') {
                const std::size_t closing = text.find(text[at], at + 1);
                if (closing == std::string_view::npos)
                    throw problem_at(
                        page, at,
                        fmt::format("expected a closing {}, found the end of the line", text[at]));
                word += text.substr(at + 1, closing - at - 1);
                at = closing;
            } else if (needs_shell.find(text[at]) != std::string_view::npos) {
                throw problem_at(
                    page, at,
                    fmt::format("expected a command that needs no shell, found {}", text[at]),
                    "quote it if it is part of a word");
            } else {
                word += text[at];
            }
        }
    }
}

} // namespace

std::vector<PageCommand> commands_on(const Source& page) {
    std::vector<PageCommand> commands;
    std::optional<Fence> fence;    // of the block around the line
    bool is_below_command = false; // so that a line is output
    std::size_t line_number = 0;
    std::size_t next = 0;

    while (next < page.text.size()) {
        const std::size_t begin = next;
        const std::size_t end = std::min(page.text.find('\n', begin), page.text.size());
        next = std::min(end + 1, page.text.size());
        ++line_number;
        const std::string_view line = std::string_view(page.text).substr(begin, end - begin);

        if (!fence) {
            fence = fence_in(line);
            if (fence)
                fence->begin = begin + fence->indent.size();
            continue;
        }
        if (closes(*fence, line)) {
            fence.reset();
            is_below_command = false;
            continue;
        }
        // As many blanks as stand before the fence are the block's.
        const std::size_t indent =
            std::min({line.find_first_not_of(blanks), fence->indent.size(), line.size()});
        const std::string_view content = line.substr(indent);
        if (content.starts_with(our_prompt) && !needs_terminal(content)) {
            PageCommand command{.begin = begin + indent,
                                .line = line_number,
                                .text = std::string(content.substr(prompt.size())),
                                .output_begin = next,
                                .output_end = next,
                                .fence = *fence};
            read_words(page, command.begin + our_prompt.size(), end, command);
            commands.push_back(std::move(command));
            is_below_command = true;
        } else if (content.starts_with(prompt)) {
            is_below_command = false;
        } else if (is_below_command && !is_blank(line)) {
            // Blank lines belong to the output only if something follows them.
            commands.back().output_end = next;
        }
    }

    // What stands behind the block would be taken for output.
    if (fence && !commands.empty() && commands.back().begin > fence->begin)
        throw problem_at(page, fence->begin,
                         "expected a line that closes this block, found the end of the page");
    return commands;
}

std::string output_for(const Source& page, const PageCommand& command, std::string_view printed) {
    std::string lines;
    std::size_t end_of_text = 0; // behind the last line that is not blank
    for (const std::string& one : split_at(std::string(printed), '\n')) {
        const std::string line = printable(one);
        if (closes(command.fence, line))
            throw problem_at(page, command.fence.begin,
                             fmt::format("expected a longer fence, found one that the output of "
                                         "line {} has, too",
                                         command.line));
        if (line.starts_with(prompt))
            throw problem_at(page, command.begin,
                             fmt::format("expected output that is no command, found \"{}\"", line),
                             "a line that begins with $ and a blank would end the output");
        lines += (line.empty() ? "" : command.fence.indent + line) + "\n";
        if (!is_blank(line))
            end_of_text = lines.size();
    }
    lines.resize(end_of_text);
    return lines;
}

std::string with_outputs(const Source& page, const std::vector<PageCommand>& commands,
                         const std::vector<std::string>& outputs) {
    std::string text;
    std::size_t copied = 0;
    for (std::size_t i = 0; i < commands.size(); ++i) {
        text.append(page.text, copied, commands[i].output_begin - copied);
        text += outputs[i];
        copied = commands[i].output_end;
    }
    return text.append(page.text, copied);
}

} // namespace rastertrace
