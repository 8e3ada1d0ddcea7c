// SPDX-License-Identifier: MIT
#pragma once

// What a word of a command line can become: for the completions of shells. A shell asks the program, which knows its
// options, their values, and the names in the file that stands before.

#include "app/help_table.h"

#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace rastertrace {

/// What the last word can become, the words before it given, without the program's name; ":files" alone if it is the name
/// of a file. Words that are no commands or files are of no harm: then it is nothing.
std::vector<std::string> completions(std::span<const std::string> words,
                                     const std::vector<CommandGroup>& groups);

/// bash, zsh, fish.
std::vector<std::string_view> completed_shells();

/// What a shell has to read, so that it asks `rastertrace help -- WORDS`.
std::string_view completion_script(std::string_view shell);

} // namespace rastertrace
