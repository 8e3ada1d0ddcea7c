// SPDX-License-Identifier: MIT
#pragma once

// Text put into Markdown as it stands.

#include <string>

namespace rastertrace {

/// The text of a cell: printable, on one line; a bar would end the cell.
std::string in_markdown(const std::string& text);

} // namespace rastertrace
