// SPDX-License-Identifier: MIT
// The working of a pixel's color: along a line, or mixed of those of the corners.

#include "sheet.h"

#include <rastertrace/core/numbers/conversion.h>
#include <rastertrace/core/numbers/vec.h>
#include <rastertrace/trace/record/replay.h>
#include <rastertrace/trace/text/text.h>

#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <iterator>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace rastertrace {

namespace {

/// The channels of a color, in the order of Levels.
constexpr Words channel_names[] = {"red", "green", "blue", "alpha"};

std::array<int, 4> channels_of(Color color) {
    return {color.red(), color.green(), color.blue(), color.alpha()};
}

/// True if a level rounds to the one that the trace tells, as its header says that levels are rounded.
bool rounds_to(const Trace& trace, double level, int told) {
    const double of_told = std::clamp(level, 0.0, 255.0) - told;
    const bool is_cut = trace.method.triangles.color_rounding == ColorRounding::truncate;
    return std::abs(is_cut ? of_told - 0.5 : of_told) <= 0.5 + 1e-6;
}

/// 1/2 (255) + 1/2 (71.4) = 163.2 -> 163: each channel, mixed by these weights, unless that is the same at all corners;
/// nothing if the trace tells another level.
std::vector<std::string> levels_mixed(const Trace& trace,
                                      const std::vector<Levels<Rational>>& corners,
                                      const std::vector<Rational>& weights, Color told,
                                      bool tells_all) {
    std::vector<std::string> lines;
    for (std::size_t channel = 0; channel < 4; ++channel) {
        const int level = channels_of(told)[channel];
        std::vector<std::string> terms;
        Rational worked_out;
        bool is_mixed = false;
        for (std::size_t i = 0; i < corners.size(); ++i) {
            const Rational& of_corner = corners[i].of[channel];
            is_mixed = is_mixed || of_corner != corners[0].of[channel];
            worked_out += weights[i] * of_corner;
            terms.push_back(
                fmt::format("{} ({})", six_places(nearest_double(weights[i])), text(of_corner)));
        }
        // No pixel is all transparent: that would be one that nothing has drawn.
        const bool is_alpha = channel == 3;
        const double near = nearest_double(worked_out);
        if (!rounds_to(trace, is_alpha ? std::max(near, 1.0) : near, level))
            return {};
        if (is_mixed || (tells_all && !is_alpha))
            lines.push_back(fmt::format("{} = {} = {} -> {}",
                                        channel_names[channel].in(language_of_steps()),
                                        joined(terms, " + "), six_places(near), level));
    }
    return lines;
}

/// The levels of a pixel on a line with a color at each end, step by step (T2). None if the pixel has others.
std::vector<std::string> levels_by_steps(const Trace& trace, const ColorOnLine& line, Color told) {
    std::vector<std::string> lines;
    for (std::size_t channel = 0; channel < 4; ++channel) {
        const int level = channels_of(told)[channel];
        const Rational& from = line.from.of[channel];
        const Rational& to = line.to.of[channel];
        const double worked_out = nearest_double(from + line.share() * (to - from));
        if (!rounds_to(trace, worked_out, level))
            return {};
        if (from != to)
            lines.push_back(fmt::format("{} = {} + {} ({} - {}) / {} = {} -> {}",
                                        channel_names[channel].in(language_of_steps()), text(from),
                                        text(line.step), text(to), text(from), text(line.steps),
                                        six_places(worked_out), level));
    }
    return lines;
}

/// From shares on the screen those in space: each is divided by the z, or w, of its corner, and all by their sum.
std::vector<std::string> lines_in_space(const std::vector<std::string>& names,
                                        const std::vector<Rational>& on_screen,
                                        const Divisors& divisors, const SharesInSpace& in_space) {
    const auto listed = [](const std::vector<Rational>& of) {
        std::vector<std::string> texts;
        for (const Rational& one : of)
            texts.push_back(text(one));
        return joined(texts, ", ");
    };
    std::vector<std::string> weights;
    for (std::size_t i = 0; i < names.size(); ++i)
        weights.push_back(said("{} of {}", text(in_space.shares[i]), names[i]));
    return {said("weights of {}: {}, divided by {} = {}: {}, together {}", joined(names, ", "),
                 listed(on_screen), divisors.name, listed(divisors.of), listed(in_space.divided),
                 text(in_space.sum)),
            said("divided by {}: {}", text(in_space.sum), joined(weights, ", "))};
}

/// The levels of a pixel on a line.
std::vector<std::string> levels_on_line(const Trace& trace, const ColorOnLine& line, Color told) {
    if (sgn(line.steps) == 0)
        return {};
    if (line.lerp == ColorLerp::axis)
        return levels_by_steps(trace, line, told);
    const Rational share = line.share();
    auto levels = levels_mixed(trace, {line.from, line.to}, {1 - share, share}, told, false);
    if (levels.empty())
        return levels;
    std::vector<std::string> lines;
    if (line.lerp == ColorLerp::distance) {
        lines.push_back(
            said("to the far end sqrt({}), the whole line sqrt({}): {} of the color of {}",
                 text(line.to_end), text(line.length), six_places(nearest_double(1 - share)),
                 line.names[0]));
    } else {
        lines.push_back(said("{} of the way from {} to {} on the screen", text(line.way),
                             line.names[0], line.names[1]));
        const std::vector<Rational> on_screen{1 - line.way, line.way};
        if (const auto in_space =
                line.divisors ? shares_in_space(on_screen, *line.divisors) : std::nullopt)
            for (std::string& one : lines_in_space({line.names[0], line.names[1]}, on_screen,
                                                   *line.divisors, *in_space))
                lines.push_back(std::move(one));
    }
    std::move(levels.begin(), levels.end(), std::back_inserter(lines));
    return lines;
}

/// The levels of a pixel in a triangle, mixed by the weights that its corners have there: on the screen, or in space
/// where they are not equally far away.
void put_mixed_color(Sheet& sheet, Color told) {
    const auto of_sample = weights_of_sample(sheet.trace(), sheet.step, sheet.primitive);
    if (!of_sample)
        return;
    std::vector<Levels<Rational>> corners;
    for (std::size_t i = 0; i < 3; ++i) {
        const auto color = sheet.primitive.color_of(i);
        if (!color)
            return;
        corners.push_back(*color);
    }
    const auto on_screen = *of_sample->value();
    std::vector<Rational> weights(on_screen.begin(), on_screen.end());
    std::vector<std::string> lines;
    if (const auto divisors = divisors_of(sheet.at, sheet.primitive))
        if (const auto in_space = shares_in_space(weights, *divisors)) {
            lines = lines_in_space(sheet.primitive.vertices, weights, *divisors, *in_space);
            weights = in_space->shares;
        }
    std::vector<std::string> levels = levels_mixed(sheet.trace(), corners, weights, told, true);
    if (levels.empty())
        return;
    for (auto* const some : {&lines, &levels})
        for (std::string& line : *some)
            sheet.put(std::move(line));
}

/// Alpha is a channel like any other: a pixel is replaced, and nothing of it shines through.
void put_alpha(Sheet& sheet, Color told) {
    if (told.alpha() != 255 && sheet.drew_over != 0)
        sheet.put(said("alpha = {} is stored: nothing of step {} is mixed in", told.alpha(),
                       sheet.trace().number_of(sheet.drew_over)));
}

} // namespace

void write_ray(Sheet& sheet) {
    const auto start = color_on_edge_of_fan(sheet.at, sheet.primitive);
    if (!start)
        return;
    const auto ray = sheet.trace().step(sheet.at.ray()).as<RayStep>();
    const auto edge = sheet.trace().step(sheet.at.edges().back()).as<EdgeStep>();
    for (const std::string& level : levels_on_line(sheet.trace(), *start, start->color))
        sheet.put(said("on {} at ({}, {}): {}", edge.edge.text(), ray.x, ray.y, level));
}

void write_color(Sheet& sheet) {
    const auto color = sheet.step.as<PixelStep>().color.color();
    const std::size_t primitive = sheet.at.primitive();
    const Color told = color.value_or(
        primitive == 0 ? Color()
                       : color_of_primitive(sheet.trace().step(primitive).as<PrimitiveStep>()));
    const bool is_triangle = sheet.primitive.kind == PrimitiveKind::triangle;
    if (const auto line = color ? color_on_line(sheet.at, sheet.primitive) : std::nullopt) {
        std::vector<std::string> levels = levels_on_line(sheet.trace(), *line, *color);
        if (is_triangle && !levels.empty())
            write_ray(sheet);
        for (std::string& level : levels)
            sheet.put(std::move(level));
    } else if (color && is_triangle &&
               (sheet.at.ray() == 0 || sheet.method().color_lerp == ColorLerp::space)) {
        put_mixed_color(sheet, *color);
    }
    put_alpha(sheet, told);
}

} // namespace rastertrace
