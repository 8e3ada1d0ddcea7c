// SPDX-License-Identifier: MIT
#include "pasted_answer.h"

#include <rastertrace/trace/text/text.h>

#include <algorithm>

namespace rastertrace {

namespace {

/// `  14  scanline y=2 ...`
bool has_step_number(std::string_view line) {
    const std::size_t number = line.find_first_not_of(' ');
    const std::size_t behind = line.find_first_not_of("0123456789", std::min(number, line.size()));
    return behind != std::string_view::npos && behind > number &&
           line.substr(behind).starts_with("  ");
}

constexpr std::string_view indent_of_working = "    ";

/// First triangle        steps 14 to 19 of 62
bool is_heading(std::string_view line) {
    const std::size_t word = line.rfind(" step");
    if (word == std::string_view::npos)
        return false;
    const std::string_view numbers = line.substr(word + 5);
    return numbers.find(" of ") != std::string_view::npos &&
           numbers.find_first_not_of("s to f0123456789") == std::string_view::npos;
}

/// a ABC  b ACD  x tested, not drawn
bool is_legend(std::string_view line) {
    return line.size() > 2 && line[1] == ' ' && line.find(':') == std::string_view::npos;
}

/// True of the title over sentences that have the numbers of their steps before them.
bool is_title(std::string_view text, std::size_t end) {
    if (end >= text.size() || !text.substr(end).starts_with("\n\n"))
        return false;
    const std::size_t next = text.find_first_not_of(" \n", end);
    return next != std::string_view::npos &&
           has_step_number(text.substr(text.rfind('\n', next) + 1));
}

} // namespace

/// The heading, the sentence, a blank line, the picture, a blank line, what its marks mean.
bool PastedAnswer::is_in_frame(std::string_view line) {
    if (is_heading(line)) {
        frame_ = FramePart::sentence;
        return true;
    }
    if (frame_ == FramePart::none || line.starts_with("stages:"))
        return line.starts_with("stages:");
    if (line.empty()) {
        frame_ = frame_ == FramePart::sentence ? FramePart::picture : FramePart::legend;
        return true;
    }
    not_judged_ += frame_ == FramePart::picture ? 1 : 0;
    return frame_ == FramePart::picture || (frame_ == FramePart::legend && is_legend(line));
}

/// It stands further in, below a sentence.
bool PastedAnswer::is_working(std::string_view line) {
    if (has_step_number(line)) {
        is_below_sentence_ = true;
        return false;
    }
    is_below_sentence_ = (is_below_sentence_ || frame_ == FramePart::sentence) &&
                         line.starts_with(indent_of_working);
    not_judged_ += is_below_sentence_ ? 1 : 0;
    return is_below_sentence_;
}

bool PastedAnswer::leaves_out(std::string_view text, std::size_t begin, std::size_t end) {
    const std::string_view line = text.substr(begin, end - begin);
    const std::string_view words = without_blanks(line);
    return begin < read_to_ || is_in_frame(words) ||
           (!words.empty() &&
            (is_working(line) || (frame_ == FramePart::none && is_title(text, end))));
}

std::size_t PastedAnswer::end_of_sentence(std::string_view text, std::size_t end) {
    if (frame_ != FramePart::sentence)
        return end;
    while (end < text.size()) {
        const std::size_t next = std::min(text.find('\n', end + 1), text.size());
        const std::string_view line = text.substr(end + 1, next - end - 1);
        if (without_blanks(line).empty() || line.starts_with(indent_of_working))
            break;
        end = next;
    }
    read_to_ = end;
    return end;
}

} // namespace rastertrace
