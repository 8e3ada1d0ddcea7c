// SPDX-License-Identifier: MIT
#include "commands/figure_file.h"

#include "app/load.h"

#include <rastertrace/figures/bitmap.h>
#include <rastertrace/figures/gif.h>
#include <rastertrace/figures/png.h>
#include <rastertrace/figures/svg.h>
#include <rastertrace/figures/tikz.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <memory>
#include <utility>

namespace rastertrace {

namespace {

/// Two pixels for a unit: letters of ten units are read well on paper.
constexpr double png_scale = 2;
constexpr double gif_scale = 1;

/// The width of the text of an `article`, which is what figures are set in.
constexpr double widest_mm = 120;
constexpr double mm_per_unit = 25.4 / 96; ///< of CSS

Bitmap checked_bitmap(const Drawing& drawing, Theme theme, double scale) {
    if (const auto problem = too_large_for_bitmap(drawing, scale))
        throw *problem;
    return bitmap_of(drawing, theme, scale);
}

} // namespace

std::vector<std::string_view> figure_format_names() {
    std::vector<std::string_view> names;
    for (const auto& ending : figure_endings)
        names.push_back(ending.text.substr(1)); // without the dot
    return names;
}

std::optional<FigureFormat> figure_format_named(std::string_view name) {
    for (const auto& ending : figure_endings)
        if (ending.text.substr(1) == name)
            return ending.format;
    return std::nullopt;
}

std::string_view name_of(FigureFormat format) {
    const auto is_it = [format](const auto& ending) { return ending.format == format; };
    return std::find_if(figure_endings.begin(), figure_endings.end(), is_it)->text.substr(1);
}

FigureFrames of_one_size(std::size_t count, std::function<Drawing(std::size_t)> draw,
                         std::size_t room) {
    double width = 0;
    double height = 0;
    // Those that have room, from the first one on, until they are asked for.
    const auto kept = std::make_shared<std::vector<std::optional<Drawing>>>(count);
    bool has_room = true;
    for (std::size_t i = 0; i < count; ++i) {
        Drawing one = draw(i);
        width = std::max(width, one.width);
        height = std::max(height, one.height);
        const std::size_t taken = memory_of(one);
        has_room = has_room && taken <= room;
        if (!has_room)
            continue;
        room -= taken;
        (*kept)[i] = std::move(one);
    }
    return {count, [=](std::size_t i) {
                Drawing one = (*kept)[i] ? *std::move((*kept)[i]) : draw(i);
                (*kept)[i].reset();
                one.width = width;
                one.height = height;
                return one;
            }};
}

namespace {

/// How many pixels or millimeters a unit has, where it has so many in a picture of no given size.
double unit_of(const Drawing& drawing, const FigureStyle& style, double usual) {
    constexpr double any = std::numeric_limits<double>::infinity();
    if (style.width || style.height)
        return std::min(style.width.value_or(any) / drawing.width,
                        style.height.value_or(any) / drawing.height);
    return usual;
}

/// In millimeters, of a .tex.
double tikz_width(const Drawing& drawing, const FigureStyle& style) {
    const double width = drawing.width * unit_of(drawing, style, mm_per_unit);
    return style.width || style.height ? width : std::min(widest_mm, width);
}

/// How long each of so many frames is seen, if nothing else was asked for: all of them for 20 seconds, one for a second
/// at most.
double seconds_for(std::size_t frames) {
    constexpr double altogether = 20;
    constexpr double shortest = 0.05;
    constexpr double longest = 1;
    constexpr double hundred = 100; // a GIF has hundredths
    return std::round(hundred *
                      std::clamp(altogether / static_cast<double>(frames), shortest, longest)) /
           hundred;
}

} // namespace

double letter_scale_for_tex(const std::function<double(double scale)>& width_with,
                            const FigureStyle& style) {
    // Some of what a figure has does not get narrower, so one round may not be enough; if a round brings nothing, no other
    // one does.
    constexpr int most_rounds = 4;
    constexpr double enough = 1.03;
    const double widest = style.width.value_or(widest_mm) / mm_per_unit;
    double scale = 1;
    double width = width_with(scale);
    for (int round = 0; round < most_rounds && width > enough * widest; ++round) {
        const double larger = scale * width / widest;
        const double narrower = width_with(larger);
        if (narrower > width / enough)
            break;
        scale = larger;
        width = narrower;
    }
    return scale;
}

std::string figure_in(FigureFormat format, const Drawing& drawing, const FigureStyle& style) {
    switch (format) {
    case FigureFormat::svg:
        return value_or_throw(svg_of(drawing, style.theme, unit_of(drawing, style, 1)));
    case FigureFormat::png:
        return value_or_throw(png_of(checked_bitmap(
            drawing, style.theme, unit_of(drawing, style, style.scale.value_or(png_scale)))));
    case FigureFormat::tex:
        return value_or_throw(tikz_of(drawing, style.theme, tikz_width(drawing, style)));
    case FigureFormat::gif:
        return animation_in(format, {1, [&drawing](std::size_t) { return drawing; }}, style);
    case FigureFormat::txt:
    case FigureFormat::html:
        break;
    }
    return {};
}

std::string animation_in(FigureFormat format, const FigureFrames& frames,
                         const FigureStyle& style) {
    const double seconds = style.seconds.value_or(seconds_for(frames.count));
    if (format == FigureFormat::gif) {
        const auto bitmap = [&](std::size_t i) {
            const Drawing frame = frames.at(i);
            return checked_bitmap(frame, style.theme,
                                  unit_of(frame, style, style.scale.value_or(gif_scale)));
        };
        return value_or_throw(gif_of(frames.count, bitmap, {.seconds = seconds}));
    }
    std::vector<Drawing> drawings;
    for (std::size_t i = 0; i < frames.count; ++i)
        drawings.push_back(frames.at(i));
    if (format == FigureFormat::tex)
        return value_or_throw(tikz_of(drawings, style.theme, tikz_width(drawings.back(), style)));
    return value_or_throw(
        animated_svg_of(drawings, seconds, style.theme, unit_of(drawings.back(), style, 1)));
}

Drawing contact_sheet(const FigureFrames& frames, std::size_t first, std::size_t last,
                      std::size_t columns, const std::string& title) {
    Drawing sheet{.title = title};
    for (std::size_t i = first; i <= last; ++i) {
        Drawing frame = frames.at(i);
        const auto column = static_cast<double>((i - first) % columns);
        const auto row = static_cast<double>((i - first) / columns);
        const Place corner{column * frame.width, row * frame.height};
        sheet.width = std::max(sheet.width, corner.x + frame.width);
        sheet.height = std::max(sheet.height, corner.y + frame.height);
        sheet.description += (i == first ? "" : " ") + frame.description;
        place(std::move(frame), corner, sheet);
    }
    return sheet;
}

} // namespace rastertrace
