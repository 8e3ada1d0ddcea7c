// SPDX-License-Identifier: MIT
#include "exercise_id.h"

#include <rastertrace/trace/text/byte_order_mark.h>
#include <rastertrace/trace/text/text.h>

#include <fmt/core.h>

#include <algorithm>
#include <utility>

namespace rastertrace {

namespace {

constexpr std::string_view exercise_line_begin = "# exercise ";

} // namespace

Result<std::string> exercise_id(std::string_view typed) {
    constexpr std::size_t most = 100;
    const auto refuse = [&](std::string message) { return problem_of("", std::move(message)); };
    if (typed.size() > most)
        return refuse(
            fmt::format("expected an ID of at most {} letters, found {}", most, typed.size()));
    std::string_view seed = typed;
    if (const std::size_t colon = typed.find(':'); colon != std::string_view::npos) {
        if (typed.substr(0, colon) != std::to_string(exercise_version))
            return refuse(fmt::format("expected an ID of version {}, found one of version \"{}\"",
                                      exercise_version, typed.substr(0, colon)));
        seed = typed.substr(colon + 1);
    }
    if (seed.empty())
        return refuse("expected an ID, found an empty one");
    const bool has_control = std::any_of(seed.begin(), seed.end(), [](char c) {
        return static_cast<unsigned char>(c) < 0x20 || c == 0x7F;
    });
    if (has_control)
        return refuse(
            "expected an ID without control characters, such as the ends of lines, found some");
    return fmt::format("{}:{}", exercise_version, seed);
}

std::string exercise_line(std::string_view id) {
    return fmt::format("{}{}\n", exercise_line_begin, id);
}

Result<std::string> exercise_of_sheet(const Source& sheet) {
    for (const std::string& whole : split_at(sheet.view(), '\n')) {
        std::string_view typed = whole;
        typed.remove_prefix(size_of_mark(typed));
        if (typed.starts_with(exercise_line_begin)) {
            typed.remove_prefix(exercise_line_begin.size());
            while (!typed.empty() && (typed.back() == '\r' || typed.back() == ' '))
                typed.remove_suffix(1);
            auto id = exercise_id(typed);
            if (!id)
                return problem_of(sheet.name, id.problem().message);
            return id;
        }
    }
    return problem_of(
        sheet.name, "expected a line that names the exercise, as `# exercise 1:anna`, found none");
}

} // namespace rastertrace
