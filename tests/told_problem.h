// SPDX-License-Identifier: MIT
#pragma once

// Problems as they are told about a place of a text.
//
//     EXPECT_EQ(complaint(text), told_problem(text, "scene.json:1:11: expected ..., found 5"));

#include <cstddef>
#include <cstdio>
#include <sstream>
#include <string>

namespace rastertrace {

/// A line, a caret under its column, and the hint if there is one.
inline std::string quoted_at(std::size_t column, const std::string& line,
                             const std::string& hint = "") {
    return "\n" + line + "\n" + std::string(column - 1, ' ') + "^" +
           (hint.empty() ? "" : "\nhint: " + hint);
}

/// `file:line:column: message`, and behind it that line of the text unless it is empty.
inline std::string told_problem(const std::string& text, const std::string& message,
                                const std::string& hint = "") {
    std::size_t line = 0, column = 0;
    std::sscanf(message.c_str(), "%*[^:]:%zu:%zu", &line, &column);
    std::istringstream lines(text);
    std::string quoted;
    for (std::size_t i = 0; i < line; ++i)
        if (!std::getline(lines, quoted))
            quoted.clear();
    return quoted.empty() ? message : message + quoted_at(column, quoted, hint);
}

} // namespace rastertrace
