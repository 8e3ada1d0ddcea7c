// SPDX-License-Identifier: MIT
#pragma once

// A text as the outlines of its letters.
//
//     add_lettering(label, 2, 0, coverage);

#include "coverage.h"

namespace rastertrace {

/// Adds a text to what is covered, `scale` pixels per unit, each letter larger by `rim` pixels on every side.
void add_lettering(const Label& label, double scale, double rim, PixelCoverage& coverage);

} // namespace rastertrace
