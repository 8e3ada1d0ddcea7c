// SPDX-License-Identifier: MIT
#pragma once

// Figures in the formats of their files.
//
//     const auto bytes = figure_in(FigureFormat::svg, drawing, {});

#include "app/option_values.h"

#include <rastertrace/figures/drawing.h>
#include <rastertrace/figures/theme.h>

#include <array>
#include <cstddef>
#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace rastertrace {

enum class FigureFormat : std::uint8_t { svg, png, tex, txt, gif, html };

inline constexpr std::array<Ending<FigureFormat>, 6> figure_endings{
    {{".svg", FigureFormat::svg},
     {".png", FigureFormat::png},
     {".tex", FigureFormat::tex},
     {".txt", FigureFormat::txt},
     {".gif", FigureFormat::gif},
     {".html", FigureFormat::html}}};

/// svg, png, ...
std::vector<std::string_view> figure_format_names();
std::optional<FigureFormat> figure_format_named(std::string_view name);
std::string_view name_of(FigureFormat format);

/// How figures are written.
struct FigureStyle {
    Theme theme = Theme::automatic;
    std::optional<double> scale = {};   ///< of a .png or .gif: pixels of a unit
    std::optional<double> width = {};   ///< of the picture: pixels; of a .tex, millimeters
    std::optional<double> height = {};  ///< the same; with both, it fits into them
    std::optional<double> seconds = {}; ///< for each frame, at least 0.02
};

/// The size of letters, as FigureOptions has it, with which a .tex has none that cover one another: `width_with` is how
/// wide the drawing is with letters of a size.
double letter_scale_for_tex(const std::function<double(double scale)>& width_with,
                            const FigureStyle& style);

/// The frames of an animation, each made when it is asked for.
struct FigureFrames {
    std::size_t count = 0;
    std::function<Drawing(std::size_t)> at; ///< from 0; an animation needs all of one size
};

/// Drawings that are all as large as the largest of them. Each is drawn right away, to find out how large it is, and kept
/// until it is asked for; those that have no room any more, in bytes, are drawn again.
FigureFrames of_one_size(std::size_t count, std::function<Drawing(std::size_t)> draw,
                         std::size_t room = 200'000'000);

/// The bytes of a file with one drawing: .svg, .png, .tex, .gif. Throws a Problem.
std::string figure_in(FigureFormat format, const Drawing& drawing, const FigureStyle& style);

/// The bytes of a file with all of them, one after the other: .svg, .gif, .tex (overlays of beamer). Throws a Problem.
std::string animation_in(FigureFormat format, const FigureFrames& frames, const FigureStyle& style);

/// Drawings on one sheet, in rows of so many columns: those from `first` to `last`, both included.
Drawing contact_sheet(const FigureFrames& frames, std::size_t first, std::size_t last,
                      std::size_t columns, const std::string& title);

} // namespace rastertrace
