// SPDX-License-Identifier: MIT
#include "page.h"

#include <rastertrace/trace/text/text.h>

#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <optional>
#include <utility>

namespace rastertrace {

namespace {

constexpr std::string_view blanks = " \t";
constexpr std::string_view prompt = "$ ";
constexpr std::string_view our_prompt = "$ rastertrace ";

/// What a shell acts on unless it is quoted: what POSIX lists, and what bash adds to that.
constexpr std::string_view needs_shell = "|&;<>()$`*?[]{}~!";

bool is_blank(std::string_view text) {
    return text.find_first_not_of(blanks) == std::string_view::npos;
}

/// How far the run of `mark` that begins at `begin` goes.
std::size_t end_of_run(std::string_view text, std::size_t begin, char mark) {
    return std::min(text.find_first_not_of(mark, begin), text.size());
}

/// The fence that a line outside of code blocks is, as CommonMark has it; but it may be indented by
/// any number of blanks, as it is in the items of a list.
std::optional<Fence> fence_opened_by(std::string_view line) {
    const std::size_t begin = std::min(line.find_first_not_of(blanks), line.size());
    const char mark = line.substr(begin).starts_with('~') ? '~' : '`';
    const std::size_t end = end_of_run(line, begin, mark);
    if (end - begin < 3)
        return std::nullopt;
    // ```So``` is code within a line of text.
    if (mark == '`' && line.find('`', end) != std::string_view::npos)
        return std::nullopt;
    return Fence{.indent = std::string(line.substr(0, begin)), .mark = mark, .length = end - begin};
}

/// True for the line that ends the block: as many marks or more, indented by at most three more
/// blanks, and nothing behind them.
bool closes(const Fence& fence, std::string_view line) {
    const std::size_t begin = std::min(line.find_first_not_of(blanks), line.size());
    const std::size_t end = end_of_run(line, begin, fence.mark);
    return begin <= fence.indent.size() + 3 && end - begin >= fence.length &&
           is_blank(line.substr(end));
}

/// Where a line of a block begins once as many blanks as stand before its fence are gone.
std::size_t content_begin(const Fence& fence, std::string_view line) {
    const std::size_t begin = std::min(line.find_first_not_of(blanks), line.size());
    return std::min(begin, fence.indent.size());
}

/// True of a player, which a reader begins; what it prints or lists without one, or refuses, is an output like any other.
bool needs_terminal(std::string_view command) {
    constexpr std::array outputs{" --print", " --keys", " --help", " -h", "# exit"};
    return command.starts_with("$ rastertrace play ") &&
           std::none_of(outputs.begin(), outputs.end(), [command](std::string_view output) {
               return command.find(output) != std::string_view::npos;
           });
}

/// The exit status that a comment states: `exit 2`. Any other comment states none.
std::optional<int> exit_status_in(std::string_view comment) {
    constexpr std::string_view exit = "exit ";
    const std::size_t begin = comment.find(exit);
    if (begin == std::string_view::npos || !is_blank(comment.substr(0, begin)))
        return std::nullopt;
    const std::string_view number = comment.substr(begin + exit.size());
    int status = 0;
    const char* const end = number.data() + number.size();
    const auto read = std::from_chars(number.data(), end, status);
    if (read.ec != std::errc{} || !is_blank({read.ptr, end}) || status < 0 || status > 255)
        return std::nullopt;
    return status;
}

/// Reads a command line as a shell would: words with their quotes taken away, and a comment.
class CommandLine {
public:
    /// `begin` and `end` are bytes of the page.
    CommandLine(const Source& page, std::size_t begin, std::size_t end)
        : page_(page), text_(std::string_view(page.text).substr(0, end)), at_(begin) {}

    void read_into(PageCommand& command) {
        while (skip_blanks()) {
            if (text_[at_] == '#') {
                command.exit_status = exit_status_in(text_.substr(at_ + 1)).value_or(0);
                return;
            }
            command.words.push_back(read_word());
        }
    }

private:
    /// False at the end of the line.
    bool skip_blanks() {
        at_ = std::min(text_.find_first_not_of(blanks, at_), text_.size());
        return at_ < text_.size();
    }

    std::string read_word() {
        std::string word;
        while (at_ < text_.size() && blanks.find(text_[at_]) == std::string_view::npos) {
            const char c = text_[at_];
            if (c == '\'' || c == '"') {
                word += read_quoted(c);
                continue;
            }
            if (c == '\\' && ++at_ == text_.size())
                throw problem_at(page_, at_ - 1,
                                 "expected a character behind the backslash, found the end of the "
                                 "line",
                                 "a command is one line");
            if (c != '\\' && needs_shell.find(c) != std::string_view::npos)
                refuse(c, "quote it if it is part of a word");
            word += text_[at_++];
        }
        return word;
    }

    /// What stands between two quotes. Between double ones, a backslash takes away the meaning that
    /// some characters have there; before others it stands for itself.
    std::string read_quoted(char quote) {
        const std::size_t opening = at_++;
        std::string text;
        for (; at_ < text_.size() && text_[at_] != quote; ++at_) {
            const std::string_view rest = text_.substr(at_);
            constexpr std::string_view obeyed = "$`\"\\";
            if (quote == '"' && rest.size() > 1 && rest[0] == '\\' &&
                obeyed.find(rest[1]) != std::string_view::npos)
                ++at_;
            else if (quote == '"' && (rest[0] == '$' || rest[0] == '`'))
                refuse(rest[0], "single quotes make it part of a word");
            text += text_[at_];
        }
        if (at_ == text_.size())
            throw problem_at(
                page_, opening,
                fmt::format("expected a closing {}, found the end of the line", quote));
        ++at_;
        return text;
    }

    [[noreturn]] void refuse(char found, std::string hint) const {
        throw problem_at(page_, at_,
                         fmt::format("expected a command that needs no shell, found {}", found),
                         std::move(hint));
    }

    const Source& page_;
    std::string_view text_; ///< of the page, up to the end of the line
    std::size_t at_;
};

} // namespace

std::vector<PageCommand> commands_on(const Source& page) {
    std::vector<PageCommand> commands;
    std::optional<Fence> fence;    // of the block around the line
    bool is_below_command = false; // so that a line is output
    std::size_t line_number = 0;
    std::size_t next = 0;

    while (next < page.text.size()) {
        // The line without what ends it.
        const std::size_t begin = next;
        const std::size_t newline = std::min(page.text.find('\n', begin), page.text.size());
        next = std::min(newline + 1, page.text.size());
        ++line_number;
        std::string_view line = std::string_view(page.text).substr(begin, newline - begin);
        if (line.ends_with('\r'))
            line.remove_suffix(1);

        if (!fence) {
            fence = fence_opened_by(line);
            if (fence)
                fence->begin = begin + fence->indent.size();
            continue;
        }
        if (closes(*fence, line)) {
            fence.reset();
            is_below_command = false;
            continue;
        }
        const std::size_t indent = content_begin(*fence, line);
        const std::string_view content = line.substr(indent);
        if (content.starts_with(our_prompt) && !needs_terminal(content)) {
            PageCommand command{
                .begin = begin + indent,
                .line = line_number,
                .text = std::string(content.substr(prompt.size())),
                .output_begin = next,
                .output_end = next,
                .fence = *fence,
                .line_end = page.text.substr(begin + line.size(), next - begin - line.size())};
            CommandLine(page, command.begin + our_prompt.size(), begin + line.size())
                .read_into(command);
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
    while (!printed.empty()) {
        const std::size_t newline = std::min(printed.find('\n'), printed.size());
        const std::string line = printable(printed.substr(0, newline));
        printed.remove_prefix(std::min(newline + 1, printed.size()));

        if (closes(command.fence, command.fence.indent + line))
            throw problem_at(page, command.fence.begin,
                             fmt::format("expected a longer fence, found one that the output of "
                                         "line {} has, too",
                                         command.line));
        if (line.starts_with(prompt))
            throw problem_at(page, command.begin,
                             fmt::format("expected output that is no command, found \"{}\"", line),
                             "a line that begins with $ and a blank would end the output");
        if (!line.empty())
            lines += command.fence.indent + line;
        lines += command.line_end;
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
