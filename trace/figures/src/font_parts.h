// SPDX-License-Identifier: MIT
#pragma once

// The files of trace/figures/font, as the build has put them into the program (cmake/embed.cmake).

namespace rastertrace {

extern const unsigned char DejaVuSans_ttf[];      // NOLINT: embed.cmake makes plain arrays
extern const unsigned char DejaVuSans_Bold_ttf[]; // NOLINT
extern const unsigned char DejaVuSansMono_ttf[];  // NOLINT

} // namespace rastertrace
