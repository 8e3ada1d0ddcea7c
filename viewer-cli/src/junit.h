// SPDX-License-Identifier: MIT
#pragma once

// What all JUnit reports have in common.

#include <string>

namespace rastertrace {

/// Text of several lines in XML: only their ends stay as they are.
std::string escaped_lines(const std::string& text);

/// The document around `<testsuite>` elements, each a line of its own.
std::string junit_document(const std::string& suites);

} // namespace rastertrace
