// SPDX-License-Identifier: MIT
#pragma once

#include <string>

namespace rastertrace {

/// What `--version` prints; with `--verbose` also how the program was built, and what it finds.
std::string version_text(bool is_verbose);

} // namespace rastertrace
