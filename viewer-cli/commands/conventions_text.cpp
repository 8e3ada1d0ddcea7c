// SPDX-License-Identifier: MIT
#include "commands/conventions_text.h"

#include <rastertrace/trace/text/conventions.h>
#include <rastertrace/trace/text/text.h>

#include <fmt/core.h>

#include <string_view>
#include <vector>

namespace rastertrace {

namespace {

/// What a row sets of a key; a dash if it does not.
std::string_view value_in(const ConventionRow& row, std::string_view key) {
    for (const auto& [name, value] : row.method)
        if (name == key)
            return value;
    return "-";
}

/// The settings as they stand in a scene: `rows half-open, rounding half-open`.
std::string other_settings(const ConventionRow& row) {
    std::vector<std::string> all;
    for (const auto& [name, value] : row.method)
        if (name != "fill" && name != "sample" && name != "line" && name != "depth")
            all.push_back(fmt::format("{} {}", name, value));
    return all.empty() ? "-" : joined(all, ", ");
}

} // namespace

std::string conventions_text() {
    const auto line = [](std::string_view name, std::string_view fill, std::string_view sample,
                         std::string_view lines, std::string_view depth, std::string_view others) {
        return fmt::format("{:<13} {:<12} {:<8} {:<13} {:<10} {}\n", name, fill, sample, lines,
                           depth, others);
    };
    std::string text = line("convention", "fill", "sample", "line", "depth", "other keys");
    for (const ConventionRow& row : convention_rows())
        text += line(row.name, value_in(row, "fill"), value_in(row, "sample"),
                     value_in(row, "line"), value_in(row, "depth"), other_settings(row));
    for (const ConventionRow& row : convention_rows())
        text += fmt::format("\n{}: {}\n  viewport  {}\n  source    {}\n  unusual   {}\n", row.name,
                            row.what, name_of_view(row), row.source, row.unusual);
    return text;
}

} // namespace rastertrace
