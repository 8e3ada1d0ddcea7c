// SPDX-License-Identifier: MIT
#pragma once

// The words of a command line, before they are read as options, and what is wrong with them if they
// cannot be; and what is said without any.

#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace rastertrace {

/// True if one of the words behind a command is the file `-`.
bool reads_standard_input(std::span<const char* const> words);

/// What the program says if it is called without a word.
inline constexpr std::string_view welcome = R"(rastertrace: a rasterizer you can watch think

It draws a scene, writes down every decision with its numbers, and shows them.

  rastertrace examples -o examples     copies the examples, if they are not there
  rastertrace show examples/t0-fill/first-triangle.json --every scanline
  rastertrace trace examples/t0-fill/first-triangle.json -o first.trace.json

`rastertrace --help` lists the commands, `rastertrace show --help` explains one.
)";

inline constexpr std::string_view exit_statuses =
    "Exit status: 0 fine; 1 a difference or a broken rule; 2 bad usage or input; 3 the system "
    "failed.";

/// The words, the program's name first. A file without a command is shown; no command has a point
/// or a slash in its name.
std::vector<const char*> words_with_command(std::span<const char* const> arguments);

/// Throws at an empty word, as a script makes it of a variable that is not set: no file, name or
/// number is "".
void refuse_empty_words(std::span<const char* const> words);

/// What is wrong with a command line, and what may have been meant.
struct Complaint {
    std::string message;
    std::string hint;
};

/// The first option that does not exist, if there is one, and which one is near.
std::optional<Complaint> unknown_option(std::span<const char* const> words,
                                        const std::vector<std::string>& options);

/// A word as a shell takes it, in quotes if it has to be.
std::string shell_word(const std::string& word);

/// True if one of them is a condition of a step, like y=2.
bool have_condition(std::span<const char* const> words);

} // namespace rastertrace
