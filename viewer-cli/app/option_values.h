// SPDX-License-Identifier: MIT
#pragma once

// Reads the values of options. What does not fit is refused: "--region: expected ..., found ...".
//
// The ending of an output's name says which format is meant. A command refuses an ending that it cannot write.
//
//     constexpr std::array endings{Ending<TraceLayout>{".json", TraceLayout::json}, ...};
//     const auto layout = format_by_ending("x.png", endings);  // throws: expected ...

#include "frames/terminal_text.h"

#include <rastertrace/trace/record/trace_options.h>
#include <rastertrace/trace/text/named_value.h>
#include <rastertrace/trace/text/problem.h>
#include <rastertrace/trace/text/text.h>

#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <cstddef>
#include <filesystem>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <system_error>
#include <utility>
#include <vector>

namespace rastertrace {

/// Throws: an option's value that does not fit.
[[noreturn]] void refuse_value(std::string_view option, std::string_view expected,
                               std::string_view found, std::string hint = {});

/// The whole number that a text is, if it is one and fits.
template <typename Integer> std::optional<Integer> whole_number(std::string_view text) {
    Integer value = 0;
    const auto read = std::from_chars(text.data(), text.data() + text.size(), value);
    if (read.ec != std::errc{} || read.ptr != text.data() + text.size())
        return std::nullopt;
    return value;
}

/// The whole number that an option gives, from `least` to `most`; nothing if it is not given.
template <typename Integer>
std::optional<Integer> number_in_option(std::string_view option, std::string_view text,
                                        Integer least, Integer most,
                                        std::string_view what = "a whole number") {
    if (text.empty())
        return std::nullopt;
    const auto number = whole_number<Integer>(text);
    if (!number || *number < least || *number > most)
        refuse_value(option, fmt::format("{} from {} to {}", what, least, most), text);
    return number;
}

/// Two such numbers with an x between them, as in 80x24, each from 1 to `most`.
std::pair<std::size_t, std::size_t> size_in_option(std::string_view option,
                                                   std::string_view expected, std::string_view text,
                                                   std::size_t most);

/// What one of several names stands for, as `named` has it; nothing if no name is given.
template <typename Named>
auto value_of(std::string_view option, const std::string& text,
              const std::vector<std::string_view>& names, const Named& named)
    -> decltype(named(std::string_view())) {
    if (text.empty())
        return std::nullopt;
    const auto value = named(text);
    if (!value)
        refuse_value(option, fmt::format("one of {}", joined(names, ", ")), text,
                     did_you_mean(text, names));
    return value;
}

/// The same where the names are in the order of the values.
template <typename Value>
std::optional<Value> value_of(std::string_view option, const std::string& text,
                              const std::vector<std::string_view>& names) {
    return value_of(option, text, names,
                    [&names](std::string_view name) { return value_named<Value>(names, name); });
}

/// What a list of names stands for, each once; nothing if no list is given. `what` are such values.
template <typename Value>
std::vector<Value> values_of(std::string_view option, std::string_view what, std::string_view text,
                             const std::vector<std::string_view>& names,
                             std::optional<Value> (*named)(std::string_view)) {
    std::vector<Value> values;
    if (text.empty())
        return values;
    for (const std::string& word : split_at(text, ',')) {
        const auto value = named(word);
        if (!value)
            refuse_value(option, fmt::format("{} out of {}", what, joined(names, ",")), word,
                         did_you_mean(word, names));
        if (std::find(values.begin(), values.end(), *value) == values.end())
            values.push_back(*value);
    }
    return values;
}

/// The value of --region, if it is given.
std::optional<Region> region_of(const std::string& text);

/// The values of --color.
inline constexpr std::array<std::string_view, 3> color_choices{"auto", "always", "never"};

/// The value of --color; automatic if it is not given.
ColorChoice color_choice_of(const std::string& text);

/// True if --format is json, or if --json is given. Refuses a format other than text and json.
bool is_json(const std::string& format, bool has_flag);

template <typename Format> struct Ending {
    std::string_view text; ///< ".svg"
    Format format;
};

/// The ending of a name, from its last dot on; "" if it has none.
inline std::string ending_of(const std::string& path) {
    return std::filesystem::path(path).extension().string();
}

/// Refuses the name of an output for its ending. What another command writes is told.
[[noreturn]] void refuse_ending(const std::string& path,
                                const std::vector<std::string_view>& known);

/// All endings, for refuse_ending.
template <typename Format>
std::vector<std::string_view> endings_in(std::span<const Ending<Format>> endings) {
    std::vector<std::string_view> known;
    for (const Ending<Format>& one : endings)
        known.push_back(one.text);
    return known;
}

/// The format that the ending of a name stands for; nothing if it has no ending. Throws a Problem for another one.
template <typename Format>
std::optional<Format> format_by_ending(const std::string& path,
                                       std::span<const Ending<Format>> endings) {
    const std::string ending = ending_of(path);
    if (ending.empty())
        return std::nullopt;
    for (const Ending<Format>& one : endings)
        if (one.text == ending)
            return one.format;
    refuse_ending(path, endings_in(endings));
}

} // namespace rastertrace
