// SPDX-License-Identifier: MIT
#pragma once

// A drawing for LaTeX: a bare `tikzpicture`, to be put into a document with \input. The document needs
// \usepackage{tikz} and nothing else. Text is set in the document's font, and in the one of its sizes that comes nearest
// to that of the drawing, at least \scriptsize; fractions are set as mathematics.
//
//     tikz_of(drawing, Theme::light, 80);  // % To be used with \usepackage{tikz}: \input{FILE}

#include <rastertrace/figures/drawing.h>
#include <rastertrace/figures/theme.h>
#include <rastertrace/trace/text/problem.h>

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <string_view>

namespace rastertrace {

/// The most places of a picture: TeX has five million words of memory, where some 40,000 places of lines fit
/// beside a document. A rectangle counts as two places, a dot as four, a label as twenty.
inline constexpr std::size_t most_tikz_places = 40'000;

enum class TexFont : std::uint8_t {
    proportional,
    with_names, ///< words of capital letters, and x, y, z, w, d, t, are names: mathematics
    in_cell,    ///< fractions stay in the line
    fixed_width,
};

/// A text as LaTeX sets it, letter by letter. What cannot be seen is shown, as printable() does; characters that
/// pdflatex does not know are shown as their number, U+05D0, in small letters.
std::string tex_escaped(std::string_view text, TexFont font = TexFont::proportional);

/// The picture, `width_mm` millimeters wide; or why there is none: it would be too large for pdflatex.
Result<std::string> tikz_of(const Drawing& drawing, Theme theme, double width_mm);

/// The same of drawings of one size, one after the other: the overlays of a frame of beamer.
Result<std::string> tikz_of(std::span<const Drawing> frames, Theme theme, double width_mm);

} // namespace rastertrace
