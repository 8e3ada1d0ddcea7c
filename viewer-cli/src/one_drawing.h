// SPDX-License-Identifier: MIT
#pragma once

// Figures of a step in space, in small pictures on one sheet.

#include "commands.h"

#include <rastertrace/figures/house_style.h>

namespace rastertrace {

/// The looks that a command's --style names. Throws a Problem.
HouseStyle style_of(const FigureCommand& command);

/// True of a .tex without --font-size: letters are chosen so that they have room.
bool chooses_letters(const FigureCommand& command, FigureFormat format);

/// Writes the frames of one step in space, on a sheet. Throws a Problem.
ExitStatus write_space_frames(const FigureCommand& command, FigureFormat format);

} // namespace rastertrace
