// SPDX-License-Identifier: MIT
#pragma once

// `rastertrace figure -o FILE.html`: a page to click through.

#include "app/exit_status.h"
#include "commands/figure_command.h"

namespace rastertrace {

/// Writes the page of all frames of the input. Throws a Problem.
ExitStatus write_page(const FigureCommand& command);

} // namespace rastertrace
