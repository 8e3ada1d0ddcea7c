// SPDX-License-Identifier: MIT
#pragma once

// Which options of `rastertrace figure` go together, and with which format.

#include "commands/figure_command.h"
#include "commands/figure_file.h"

namespace rastertrace {

/// Refuses a format that cannot have what was asked for, and options that contradict each other. Throws a Problem.
void check_format(const FigureCommand& command, FigureFormat format);

} // namespace rastertrace
