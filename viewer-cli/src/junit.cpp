// SPDX-License-Identifier: MIT
#include "junit.h"

#include <rastertrace/figures/svg.h>
#include <rastertrace/trace/text/text.h>

#include <vector>

namespace rastertrace {

std::string escaped_lines(const std::string& text) {
    std::vector<std::string> lines;
    for (const std::string& line : split_at(text, '\n'))
        lines.push_back(escaped(line));
    return joined(lines, "\n");
}

std::string junit_document(const std::string& suites) {
    return "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n<testsuites>\n" + suites +
           "</testsuites>\n";
}

} // namespace rastertrace
