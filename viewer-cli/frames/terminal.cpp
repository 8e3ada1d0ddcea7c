// SPDX-License-Identifier: MIT
#include "frames/terminal.h"

#include "app/environment.h"

#include <sys/ioctl.h>
#include <unistd.h>

#include <charconv>
#include <string_view>

namespace rastertrace {

namespace {

/// A size from the environment; `otherwise` if it is not set or makes no sense.
std::size_t from_environment(const char* name, std::size_t otherwise) {
    std::size_t value = 0;
    const std::string_view digits = environment_variable(name);
    const auto read = std::from_chars(digits.data(), digits.data() + digits.size(), value);
    const bool is_number = read.ec == std::errc{} && read.ptr == digits.data() + digits.size();
    return is_number && value > 0 ? value : otherwise;
}

} // namespace

TextSize output_size() {
    winsize window{};
    if (::isatty(STDOUT_FILENO) != 0 && ::ioctl(STDOUT_FILENO, TIOCGWINSZ, &window) == 0 &&
        window.ws_col > 0 && window.ws_row > 0)
        return {window.ws_col, window.ws_row};
    const TextSize unlimited;
    return {from_environment("COLUMNS", unlimited.columns),
            from_environment("LINES", unlimited.lines)};
}

} // namespace rastertrace
