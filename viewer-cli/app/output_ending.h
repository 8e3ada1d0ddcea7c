// SPDX-License-Identifier: MIT
#pragma once

// What the ending of an output's name says of its format. A command refuses an ending that it cannot write.
//
//     constexpr std::array endings{Ending<TraceLayout>{".json", TraceLayout::json}, ...};
//     const auto layout = format_by_ending("x.png", endings);  // throws: expected ...

#include <rastertrace/trace/text/problem.h>
#include <rastertrace/trace/text/text.h>

#include <fmt/core.h>

#include <algorithm>
#include <filesystem>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace rastertrace {

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
