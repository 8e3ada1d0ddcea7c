// SPDX-License-Identifier: MIT
#include "line_blocks.h"

#include <rastertrace/trace/text/input_check.h>
#include <rastertrace/trace/text/text.h>

#include <algorithm>
#include <utility>

namespace rastertrace {

namespace {

/// Bytes of a block: twice as many as of the one before, up to the most.
constexpr std::size_t least_block = 1 << 20;
constexpr std::size_t largest_block = 4 * least_block;

/// What a file gives at once, and what is put behind the lines of a block.
constexpr std::size_t room_behind = (1 << 16) + (1 << 10);

/// Of the text behind the steps.
constexpr std::size_t most_behind = 16 << 20;

} // namespace

LineBlocks::LineBlocks(InputFile file, LineLayout layout, std::string header_line,
                       std::string_view begun, std::size_t begin)
    : file_(std::move(file)), layout_(layout), header_line_(std::move(header_line)),
      text_(header_line_ + "\n"), begin_(begin), block_size_(least_block) {
    text_ += begun;
}

/// False if there is no more, or not yet.
bool LineBlocks::read_more() {
    if (has_all_)
        return false;
    const bool has_read = file_.read_into(text_);
    has_all_ = !has_read && !may_grow_;
    return has_read;
}

/// True for the line that ends the steps.
bool LineBlocks::is_end(std::string_view line) const {
    if (line.starts_with("{\"step\""))
        return false;
    line = without_blanks(line);
    return layout_ == LineLayout::document ? line.starts_with(']') : is_end_line(line);
}

/// The whole lines in front of the line that ends the steps; all whole lines if there is none.
LineBlocks::WholeLines LineBlocks::whole_lines() const {
    const std::string_view text = lines();
    WholeLines whole;
    while (whole.size < text.size()) {
        const std::size_t newline = text.find('\n', whole.size);
        if (newline == std::string_view::npos && !has_all_)
            break;
        const std::size_t line_end = std::min(newline, text.size());
        if (is_end(text.substr(whole.size, line_end - whole.size))) {
            whole.is_last = true;
            break;
        }
        whole.size = std::min(line_end + 1, text.size());
        whole.newlines += newline == std::string_view::npos ? 0 : 1;
    }
    return whole;
}

std::optional<LineBlock> LineBlocks::next() {
    text_.reserve(front() + block_size_ + room_behind);
    while (lines().size() < block_size_ && read_more()) {
    }
    block_size_ = std::min(2 * block_size_, largest_block);
    WholeLines whole = whole_lines();
    while (whole.size == 0 && !whole.is_last && !has_all_) { // a line longer than a block
        if (lines().size() > longest_line)
            throw line_too_long({file_.name(), text_, {}}, front());
        if (!read_more() && may_grow_)
            return std::nullopt; // not a whole line yet
        whole = whole_lines();
    }
    std::string behind = header_line_ + "\n";
    behind += lines().substr(whole.size);
    text_.resize(front() + whole.size);
    LineBlock block{.text = std::exchange(text_, std::move(behind)),
                    .begin = begin_,
                    .newlines = whole.newlines,
                    .is_last = whole.is_last,
                    .is_cut_off = !whole.is_last && has_all_};
    begin_ += whole.size;
    return block;
}

std::string LineBlocks::rest() {
    while (lines().size() < most_behind && read_more()) {
    }
    return text_;
}

} // namespace rastertrace
