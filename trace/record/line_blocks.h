// SPDX-License-Identifier: MIT
#pragma once

// Reads a trace of one step a line in blocks of whole lines.
//
//     LineBlocks blocks(std::move(file), layout, header_line, begun, begin);
//     blocks.next()->text;

#include <rastertrace/trace/text/input_file.h>
#include <rastertrace/trace/text/trace_layout.h>

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>

namespace rastertrace {

/// Some whole lines.
struct LineBlock {
    std::string text{};       ///< the line of the header, then the lines of the block
    std::size_t begin = 0;    ///< where those lines stand in the file
    std::size_t newlines = 0; ///< in those lines
    bool is_last = false;     ///< the next line ends the steps
    bool is_cut_off = false;  ///< the file ends here, and no line ends the steps
};

class LineBlocks {
public:
    /// `header_line` has no blanks around it. `begun` is what has been read behind it, from byte `begin` of the file on.
    LineBlocks(InputFile file, LineLayout layout, std::string header_line, std::string_view begun,
               std::size_t begin);

    const InputFile& file() const { return file_; }
    LineLayout layout() const { return layout_; }
    const std::string& header_line() const { return header_line_; }

    /// If true, the end of the file is not taken for the end of the trace: more may be written to it.
    void let_grow(bool may_grow) { may_grow_ = may_grow; }

    /// The next block; not behind the last one. `nullopt` if a file that may grow has no whole line yet. Throws a Problem,
    /// whose line counts from that of the header.
    std::optional<LineBlock> next();

    /// Behind the last block: the line of the header, and the text behind the steps, at most some megabytes.
    std::string rest();

private:
    bool read_more();
    bool is_end(std::string_view line) const;
    struct WholeLines {
        std::size_t size = 0; ///< bytes
        std::size_t newlines = 0;
        bool is_last = false;
    };
    WholeLines whole_lines() const;
    std::string_view lines() const { return std::string_view(text_).substr(front()); }
    std::size_t front() const { return header_line_.size() + 1; }

    InputFile file_;
    LineLayout layout_;
    std::string header_line_;
    std::string text_;  ///< the line of the header, then text that is in no block yet
    std::size_t begin_; ///< where that text stands in the file
    std::size_t block_size_;
    bool has_all_ = false; ///< the file has come to its end
    bool may_grow_ = false;
};

} // namespace rastertrace
