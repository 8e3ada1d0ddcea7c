// SPDX-License-Identifier: MIT
#pragma once

// What the terminal can show, and text with colors for it: the one place that writes escape sequences.
//
//     styled("[a]", {.background = Color{255, 0, 0}}, ColorDepth::truecolor);

#include <rastertrace/core/raster/image.h>

#include <cstddef>
#include <cstdint>
#include <limits>
#include <optional>
#include <string>
#include <string_view>

namespace rastertrace {

/// How many colors a terminal has.
enum class ColorDepth : std::uint8_t {
    none,       ///< no escape sequence is written
    ansi16,     ///< SGR 40 to 47 and 100 to 107
    palette256, ///< the xterm color cube
    truecolor,  ///< 24 bit
};

/// What is asked for on the command line.
enum class ColorChoice : std::uint8_t { automatic, always, never };

/// The colors that standard output has. `automatic`: none if it is no terminal, if TERM is "dumb", or if
/// NO_COLOR is set and not empty; else what COLORTERM and TERM say. `always`: 16 at least.
ColorDepth output_colors(ColorChoice choice);

/// True if the terminal is said to show UTF-8 (setlocale(3): LC_ALL, LC_CTYPE, LANG, the first that is set).
bool output_has_unicode();

/// How much text fits; no limit where nobody said.
struct TextSize {
    std::size_t columns = std::numeric_limits<std::size_t>::max();
    std::size_t lines = std::numeric_limits<std::size_t>::max();
};

/// The size of the terminal that standard output goes to. For a file or pipe, what COLUMNS and
/// LINES say, if they are set.
TextSize output_size();

/// How a piece of text looks.
struct Style {
    std::optional<Color> background = {}; ///< the text in front of it is black or white
    bool is_reversed = false;
    std::optional<Color> foreground = {}; ///< where that is meant to be seen, too
    bool is_cursor = false;               ///< black on yellow, whatever else it is
    bool is_strong = false;               ///< what the step is about
    bool is_quiet = false;                ///< what stands around it
};

/// ASCII letters in lower case, as what is typed is compared.
std::string in_lower_case(std::string text);

/// The text with the escape sequences for its style; the text alone if there is none, or no color.
std::string styled(std::string_view text, const Style& style, ColorDepth colors);

} // namespace rastertrace
