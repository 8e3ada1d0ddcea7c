// SPDX-License-Identifier: MIT
// The working of a pixel's color: along a line, or mixed of those of the corners.

#include "sheet.h"

#include <rastertrace/core/numbers/conversion.h>
#include <rastertrace/core/numbers/vec.h>
#include <rastertrace/trace/text/text.h>

#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace rastertrace {

namespace {

/// A channel of a color.
struct Channel {
    Words name;
    std::uint8_t (Color::*of)() const;
};
constexpr Channel channels[] = {{{"red", "vermelho"}, &Color::red},
                                {{"green", "verde"}, &Color::green},
                                {{"blue", "azul"}, &Color::blue},
                                {{"alpha", "alfa"}, &Color::alpha}};

/// True if a level rounds to the one that the trace tells, as its header says that levels are rounded.
bool rounds_to(const Trace& trace, double level, int told) {
    const double of_told = std::clamp(level, 0.0, 255.0) - told;
    const bool is_cut = trace.method_value("color_rounding") == "truncate";
    return std::abs(is_cut ? of_told - 0.5 : of_told) <= 0.5 + 1e-6;
}

/// The levels of a pixel on a line with a color at each end: step by step (T2), or by its distance. None if the pixel
/// has others.
std::vector<std::string> levels_on_line(const Trace& trace, const ColorOnLine& line, Color told) {
    std::vector<std::string> lines;
    if (sgn(line.steps) == 0)
        return lines;
    for (const Channel& channel : channels) {
        const int from = (line.from.*channel.of)();
        const int to = (line.to.*channel.of)();
        const int level = (told.*channel.of)();
        const double worked_out = from + line.share() * (to - from);
        if (!rounds_to(trace, worked_out, level))
            return {};
        if (from != to)
            lines.push_back(
                line.is_by_distance
                    ? fmt::format("{} = {} ({}) + {} ({}) = {} -> {}",
                                  channel.name.in(language_of_steps()),
                                  six_places(1 - line.share()), from, six_places(line.share()), to,
                                  six_places(worked_out), level)
                    : fmt::format("{} = {} + {} ({} - {}) / {} = {} -> {}",
                                  channel.name.in(language_of_steps()), from, text(line.step), to,
                                  from, text(line.steps), six_places(worked_out), level));
    }
    if (line.is_by_distance && !lines.empty())
        lines.insert(
            lines.begin(),
            said({"to the far end sqrt({}), the whole line sqrt({}): {} of the color of {}",
                  "até o outro extremo sqrt({}), o segmento inteiro sqrt({}): {} da cor de {}"},
                 text(line.to_end), text(line.length), six_places(1 - line.share()),
                 line.from_name));
    return lines;
}

/// What the corners of a triangle weigh in a pixel, and how that is found out.
struct Mix {
    std::array<Rational, 3> weights;
    std::vector<std::string> lines = {};
};

/// From their weights on the screen those in space: each is divided by the z of its corner, and all by their sum.
Mix in_space(const Sheet& sheet, const Mix& on_screen, const CornerDistances& corners) {
    std::array<Rational, 3> shares;
    Rational sum;
    for (std::size_t i = 0; i < 3; ++i) {
        shares[i] = on_screen.weights[i] / corners.distances[i];
        sum += shares[i];
    }
    if (sgn(sum) <= 0)
        return on_screen; // so far outside the triangle, a point has none in space
    const auto listed = [](const std::array<Rational, 3>& of) {
        return fmt::format("{}, {}, {}", text(of[0]), text(of[1]), text(of[2]));
    };
    const auto& names = sheet.primitive.vertices;
    const std::array<Rational, 3> weights{shares[0] / sum, shares[1] / sum, shares[2] / sum};
    return {weights,
            {said({"weights of {}, {}, {}: {}, divided by z = {}: {}, together {}",
                   "pesos de {}, {}, {}: {}, divididos por z = {}: {}, ao todo {}"},
                  names[0], names[1], names[2], listed(on_screen.weights),
                  listed(corners.distances), listed(shares), text(sum)),
             said({"divided by {}: {} of {}, {} of {}, {} of {}",
                   "dividido por {}: {} de {}, {} de {}, {} de {}"},
                  text(sum), text(weights[0]), names[0], text(weights[1]), names[1],
                  text(weights[2]), names[2])}};
}

/// The level of each channel, mixed by these weights; nothing if the trace tells others.
std::vector<std::string> levels_mixed(const Sheet& sheet, const std::array<Rational, 3>& weights,
                                      Color told) {
    const auto colors = sheet.primitive.colors.values();
    std::vector<std::string> lines;
    for (const Channel& channel : channels) {
        const int level = (told.*channel.of)();
        std::vector<std::string> terms;
        double worked_out = 0;
        bool is_mixed = false;
        for (std::size_t i = 0; i < 3; ++i) {
            const auto corner = i < colors.size() ? colors[i].color() : std::nullopt;
            if (!corner)
                return {};
            const double weight = nearest_double(weights[i]);
            is_mixed =
                is_mixed || ((*corner).*channel.of)() != ((*colors[0].color()).*channel.of)();
            worked_out += weight * ((*corner).*channel.of)();
            terms.push_back(fmt::format("{} ({})", six_places(weight), ((*corner).*channel.of)()));
        }
        // No pixel is all transparent: that would be one that nothing has drawn.
        const bool is_alpha = channel.of == &Color::alpha;
        if (!rounds_to(sheet.trace(), is_alpha ? std::max(worked_out, 1.0) : worked_out, level))
            return {};
        if (!is_alpha || is_mixed)
            lines.push_back(fmt::format("{} = {} = {} -> {}", channel.name.in(language_of_steps()),
                                        joined(terms, " + "), six_places(worked_out), level));
    }
    return lines;
}

/// The levels of a pixel in a triangle, mixed by the weights that its corners have there: on the screen, or in space
/// where they are not equally far away.
void put_mixed_color(Sheet& sheet, Color told) {
    const auto of_sample = weights_of_sample(sheet.trace(), sheet.step, sheet.primitive);
    if (!of_sample)
        return;
    Mix mix{*of_sample->value()};
    const bool is_affine = sheet.trace().method_value("shade") == "affine";
    const auto distances = is_affine ? std::nullopt : distances_of_corners(sheet);
    if (distances && distances->differ())
        mix = in_space(sheet, mix, *distances);
    std::vector<std::string> levels = levels_mixed(sheet, mix.weights, told);
    if (levels.empty())
        return;
    for (auto* const lines : {&mix.lines, &levels})
        for (std::string& line : *lines)
            sheet.put(std::move(line));
}

/// Alpha is a channel like any other: a pixel is replaced, and nothing of it shines through.
void put_alpha(Sheet& sheet, Color told) {
    if (told.alpha() != 255 && sheet.replay.drew_over() != 0)
        sheet.put(said({"alpha = {} is stored: nothing of step {} is mixed in",
                        "alfa = {} é guardado: nada do passo {} é misturado"},
                       told.alpha(), sheet.trace().number_of(sheet.replay.drew_over())));
}

} // namespace

void write_ray(Sheet& sheet) {
    const auto start = color_on_edge_of_fan(sheet.replay, sheet.primitive);
    if (!start)
        return;
    const auto ray = sheet.trace().step(sheet.replay.ray()).as<RayStep>();
    const auto edge = sheet.trace().step(sheet.replay.edges().back()).as<EdgeStep>();
    for (const std::string& level : levels_on_line(sheet.trace(), *start, start->color))
        sheet.put(said({"on {} at ({}, {}): {}", "sobre {} em ({}, {}): {}"}, edge.edge.text(),
                       ray.x, ray.y, level));
}

void write_color(Sheet& sheet) {
    const auto color = sheet.step.as<PixelStep>().color.color();
    const Color told = color.value_or(sheet.replay.color());
    const bool is_triangle = sheet.primitive.kind == PrimitiveKind::triangle;
    if (const auto line = color ? color_on_line(sheet.replay, sheet.primitive) : std::nullopt) {
        std::vector<std::string> levels = levels_on_line(sheet.trace(), *line, *color);
        if (is_triangle && !levels.empty())
            write_ray(sheet);
        for (std::string& level : levels)
            sheet.put(std::move(level));
    } else if (color && is_triangle && sheet.replay.ray() == 0) {
        put_mixed_color(sheet, *color);
    }
    put_alpha(sheet, told);
}

} // namespace rastertrace
