// SPDX-License-Identifier: MIT
#pragma once

// A drawing as SVG: the one place that writes it. Each shape has its role as a class, and the colors are a style
// sheet at the top, so that a page can change them. Text is text; title and description are there for screen
// readers.
//
//     svg_of(drawing, Theme::automatic);  // <svg xmlns="http://www.w3.org/2000/svg" ...

#include <rastertrace/figures/drawing.h>
#include <rastertrace/figures/theme.h>
#include <rastertrace/trace/text/problem.h>

#include <span>
#include <string>
#include <string_view>

namespace rastertrace {

/// A text in an SVG or HTML document, also in attributes. What cannot be seen is shown, as printable() does.
std::string escaped(std::string_view text);

/// The most rectangles, lines, polygons, dots and texts of an SVG: programs that show it get slow beyond.
inline constexpr std::size_t most_svg_shapes = 200'000;

/// The document, `scale` pixels of a screen to a unit; or why there is none: it would have too many shapes.
Result<std::string> svg_of(const Drawing& drawing, Theme theme, double scale = 1);

/// Drawings one after the other, each for so many seconds, over and over. A program that does not know
/// animations, or a reader who wants none, sees the last one.
Result<std::string> animated_svg_of(std::span<const Drawing> frames, double seconds, Theme theme,
                                    double scale = 1);

/// The elements of shapes, to stand in an SVG of a document that has rules_of_roles().
std::string svg_elements(std::span<const Shape> shapes);

/// The rules for all roles and kinds of shape, within elements of a class. A shape has the classes of its kind and its role;
/// its `color` is that of the role, which whoever puts the shape into a document sets.
std::string rules_of_roles(std::string_view scope);

} // namespace rastertrace
