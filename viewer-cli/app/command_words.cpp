// SPDX-License-Identifier: MIT
#include "app/command_words.h"

#include "app/option_values.h"

#include <rastertrace/trace/text/text.h>

#include <fmt/core.h>

#include <algorithm>
#include <cstddef>
#include <string_view>

namespace rastertrace {

std::vector<const char*> words_with_command(std::span<const char* const> arguments) {
    std::vector<const char*> words(arguments.begin(), arguments.end());
    const std::string_view first = words[1];
    if (!first.starts_with('-') && first.find_first_of("./") != std::string_view::npos)
        words.insert(words.begin() + 1, "show");
    return words;
}

void refuse_empty_words(std::span<const char* const> words) {
    for (std::size_t i = 1; i < words.size(); ++i) {
        const std::string_view word = words[i];
        if (word.empty())
            refuse_value(i == 1 ? "rastertrace" : words[i - 1], "a word behind it", word);
        if (word.starts_with("--") && word.ends_with('='))
            refuse_value(word.substr(0, word.size() - 1), "a value", "");
    }
}

std::optional<Complaint> unknown_option(std::span<const char* const> words,
                                        const std::vector<std::string>& options) {
    for (const char* const text : words.subspan(1)) {
        const std::string word = split_at(text, '=').front();
        if (word.starts_with("--") && word != "--" &&
            std::find(options.begin(), options.end(), word) == options.end())
            return Complaint{fmt::format("{}: no such option", word),
                             did_you_mean(word, {options.begin(), options.end()})};
    }
    return std::nullopt;
}

bool reads_standard_input(std::span<const char* const> words) {
    for (std::size_t i = 2; i < words.size(); ++i) {
        const std::string_view before = words[i - 1];
        if (words[i] == std::string_view("-") && before != "-o" && before != "--output")
            return true;
    }
    return false;
}

bool have_condition(std::span<const char* const> words) {
    return std::any_of(words.begin() + 1, words.end(), [](std::string_view word) {
        return !word.starts_with('-') && word.find('=') != std::string_view::npos;
    });
}

std::string shell_word(const std::string& word) {
    constexpr std::string_view plain =
        "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789-_./=,:+";
    if (!word.empty() && word.find_first_not_of(plain) == std::string::npos)
        return word;
    std::string quoted = "'";
    for (const char c : word)
        quoted += c == '\'' ? std::string("'\\''") : std::string(1, c);
    return quoted + "'";
}

} // namespace rastertrace
