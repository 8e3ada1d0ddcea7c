// SPDX-License-Identifier: MIT
#pragma once

// A Markdown page that shows commands of this program, each with its output below:
//
//     ```
//     $ rastertrace plan scene.json
//     stage        plan      why; what it saves
//     ...
//     ```
//
// Inside a fenced code block, a line that begins with `$ rastertrace ` is a command. Its output is
// what follows, up to the next line that begins with `$ ` or to the end of the block, without the
// blank lines there: those are the author's. Nothing else on a page is looked at. docs/pages.md
// tells it to users.

#include <rastertrace/trace/text/problem.h>

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

namespace rastertrace {

/// The line that opens a fenced code block.
struct Fence {
    std::size_t begin = 0;  ///< of its first mark, a byte of the page
    std::string indent;     ///< the blanks before the marks
    std::size_t length = 0; ///< how many marks, 3 or more
};

/// A command on a page. Places are bytes of the page's text.
struct PageCommand {
    std::size_t begin = 0;               ///< of its `$`
    std::size_t line = 0;                ///< from 1
    std::string text;                    ///< as typed, from `rastertrace` on
    std::vector<std::string> words = {}; ///< without quotes, and without `rastertrace`
    int exit_status = 0;                 ///< that it should have: 2 where its comment is `# exit 2`
    std::size_t output_begin = 0;        ///< of the whole lines that are its output
    std::size_t output_end = 0;
    Fence fence; ///< of its block
};

/// The commands of a page, from top to bottom. Throws a Problem if one needs a shell, or if its
/// block has no end.
std::vector<PageCommand> commands_on(const Source& page);

/// What a command printed, as the lines of its page: indented as the block, without blank lines at
/// the end, characters that a terminal obeys made visible. Throws a Problem if a line of it would
/// end the block or be taken for a command.
std::string output_for(const Source& page, const PageCommand& command, std::string_view printed);

/// The page with other outputs, one for each of its commands, as `output_for` returns them.
std::string with_outputs(const Source& page, const std::vector<PageCommand>& commands,
                         const std::vector<std::string>& outputs);

} // namespace rastertrace
