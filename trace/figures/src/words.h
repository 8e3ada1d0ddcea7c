// SPDX-License-Identifier: MIT
#pragma once

// The words around a figure: title, legend, caption. Each is set from a height on, and returns how high it is.

#include "panel.h"

#include <string>
#include <string_view>
#include <vector>

namespace rastertrace {

/// The part of a sheet that words may take.
struct Column {
    double left;
    double right;
    double width() const { return right - left; }
};

/// The narrowest sheet on which words are set.
inline constexpr double narrowest_for_words = 300;

/// The title, and which steps are shown.
double add_title(const std::string& title, const Panel& panel, const Column& column, double y,
                 std::vector<Shape>& shapes);

/// What colors stand for. `against` is the name of the picture that is compared with.
double add_legend(const Panel& panel, const std::string& against, const Column& column, double y,
                  std::vector<Shape>& shapes);

/// A sentence whose decimals have six digits at most: it is told exactly elsewhere.
std::string with_six_digits(std::string_view sentence);

/// What the step says.
double add_caption(const std::string& caption, bool is_of_step, const Column& column, double y,
                   std::vector<Shape>& shapes);

/// A text whose formulas, $...$, have no-break spaces: none goes on in another line.
std::string with_whole_formulas(std::string_view text);

/// How its numbers come of one another.
double add_working(const std::vector<std::string>& working, const Column& column, double y,
                   std::vector<Shape>& shapes);

} // namespace rastertrace
