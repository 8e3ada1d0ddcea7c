// SPDX-License-Identifier: MIT
#include "markdown.h"

#include <rastertrace/trace/text/text.h>

namespace rastertrace {

std::string in_markdown(const std::string& text) {
    std::string escaped;
    for (const char c : printable(text))
        escaped += c == '|' ? "\\|" : std::string(1, c);
    return escaped;
}

} // namespace rastertrace
