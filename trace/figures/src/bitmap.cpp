// SPDX-License-Identifier: MIT
#include <rastertrace/figures/bitmap.h>

#include "coverage.h"
#include "lettering.h"
#include "stroke.h"

#include <fmt/core.h>

#include <algorithm>
#include <cassert>
#include <cmath>
#include <utility>

namespace rastertrace {

namespace {

/// How many pixels a length of the sheet takes.
double pixels_of(double units, double scale) {
    constexpr double rounding = 1e-6; // of a scale that is a quotient
    return std::max(1.0, std::ceil(units * scale - rounding));
}

/// `share` of 0 to `whole` of a color over another one.
Color mixed(Color over, Color below, unsigned share, unsigned whole) {
    const auto channel = [share, whole](unsigned a, unsigned b) {
        return static_cast<std::uint8_t>((a * share + b * (whole - share) + whole / 2) / whole);
    };
    return {channel(over.red(), below.red()), channel(over.green(), below.green()),
            channel(over.blue(), below.blue())};
}

/// The nearest border between pixels, within 0 and `most`.
int nearest_border(double pixels, int most) {
    return static_cast<int>(std::floor(std::clamp(pixels, 0.0, static_cast<double>(most)) + 0.5));
}

/// What lies between two borders, or at least the pixel that a thing without width is in.
struct Extent {
    int begin;
    int end;
};

Extent extent_of(double a, double b, int most) {
    if (b < a)
        std::swap(a, b);
    Extent extent{nearest_border(a, most), nearest_border(b, most)};
    if (extent.begin == extent.end && a < b && 0 <= a && a < most) {
        extent.begin = static_cast<int>(a);
        extent.end = extent.begin + 1;
    }
    return extent;
}

/// Lines of these roles lie on whole pixels where they run straight across or down.
bool is_furniture(Role role) {
    return role == Role::grid || role == Role::border || role == Role::axis;
}

class Painter {
public:
    Painter(Bitmap& bitmap, Theme theme, double scale)
        : bitmap_(bitmap), theme_(theme), scale_(scale), width_(static_cast<int>(bitmap.width)),
          height_(static_cast<int>(bitmap.height)), coverage_(width_, height_) {}

    void paint(const Areas& areas) {
        const Color color = areas.color.value_or(color_of(areas.role));
        const bool is_opaque = color.alpha() == opaque;
        for (const Rectangle& rectangle : areas.rectangles) {
            const Place a = to_pixels(rectangle.corner);
            const Place b = to_pixels({rectangle.right(), rectangle.bottom()});
            const Extent x = extent_of(a.x, b.x, width_);
            const Extent y = extent_of(a.y, b.y, height_);
            if (is_opaque)
                for (int row = y.begin; row < y.end; ++row)
                    paint_span({row, x.begin, x.end, full_coverage}, color);
            else
                coverage_.add(CoveredBox{static_cast<double>(x.begin), static_cast<double>(y.begin),
                                         static_cast<double>(x.end), static_cast<double>(y.end)});
        }
        if (!is_opaque)
            paint_covered(color);
    }

    void paint(const Pixels& pixels) {
        if (pixels.columns == 0 || pixels.side <= 0)
            return;
        const Place corner = to_pixels(pixels.corner);
        const double side = std::min(pixels.side * scale_, farthest);
        const auto border = [side](double first, std::size_t count, int most) {
            return nearest_border(first + static_cast<double>(count) * side, most);
        };
        std::vector<int> columns;
        for (std::size_t column = 0; column <= pixels.columns; ++column)
            columns.push_back(border(corner.x, column, width_));
        const std::size_t rows = pixels.colors.size() / pixels.columns;
        for (std::size_t row = 0; row < rows; ++row) {
            const Color* colors = pixels.colors.data() + row * pixels.columns;
            const int bottom = border(corner.y, row + 1, height_);
            for (int y = border(corner.y, row, height_); y < bottom; ++y)
                paint_row(y, colors, columns);
        }
    }

    void paint(const Lines& lines) {
        const Paint paint = paint_of(lines.role, theme_);
        Color color = paint.color;
        double width = paint.width * scale_;
        const bool is_sharp = is_furniture(lines.role) && paint.dashes.empty();
        if (is_sharp && width < 1) {
            // A fine line is a whole pixel of a fainter color.
            color = {color.red(), color.green(), color.blue(),
                     static_cast<std::uint8_t>(std::floor(color.alpha() * width + 0.5))};
            width = 1;
        }
        std::vector<double> dashes;
        for (const double dash : paint.dashes)
            dashes.push_back(dash * scale_);
        for (const Path& path : lines.paths) {
            const std::vector<Place> places = to_pixels(path);
            if (is_sharp && runs_straight(places))
                add_sharp(places, lines.are_closed, width);
            else
                add_stroke(places,
                           {.width = width, .dashes = dashes, .joins_ends = lines.are_closed},
                           coverage_);
        }
        paint_covered(color);
    }

    void paint(const Polygons& polygons) {
        for (const Path& path : polygons.paths)
            coverage_.add(to_pixels(path));
        paint_covered(color_of(polygons.role));
    }

    void paint(const Dots& dots) {
        const Color color = color_of(dots.role);
        // Some at a time: what all of them cover may be more than there is memory for.
        constexpr std::size_t at_a_time = 4096;
        std::size_t waiting = 0;
        for (const Place& center : dots.centers) {
            add_disc(to_pixels(center), std::min(dots.radius * scale_, farthest), coverage_);
            if (++waiting % at_a_time == 0)
                paint_covered(color);
        }
        paint_covered(color);
    }

    void paint(const Label& label) {
        if (label.has_rim) {
            constexpr double rim_units = 1.5;
            add_lettering(label, scale_, rim_units * scale_, coverage_);
            paint_covered(color_of(Role::paper));
        }
        add_lettering(label, scale_, 0, coverage_);
        paint_covered(label.color.value_or(color_of(label.role)));
    }

private:
    static constexpr int opaque = 255;
    /// Pixels from the sheet's corner: what is farther away is drawn there, and cannot be seen.
    static constexpr double farthest = 1e9;

    Color color_of(Role role) const { return paint_of(role, theme_).color; }

    Place to_pixels(Place place) const {
        return {std::clamp(place.x * scale_, -farthest, farthest),
                std::clamp(place.y * scale_, -farthest, farthest)};
    }

    std::vector<Place> to_pixels(const Path& path) const {
        std::vector<Place> places;
        places.reserve(path.size());
        for (const Place& place : path)
            places.push_back(to_pixels(place));
        return places;
    }

    void paint_span(const CoverageRun& run, Color color) {
        Color* row = bitmap_.colors.data() + static_cast<std::size_t>(run.y) * bitmap_.width;
        constexpr unsigned whole = opaque * full_coverage;
        const unsigned share = color.alpha() * static_cast<unsigned>(run.level);
        if (share == whole)
            std::fill(row + run.begin, row + run.end, color);
        else
            std::for_each(row + run.begin, row + run.end, [color, share](Color& below) {
                below = mixed(color, below, share, whole);
            });
    }

    void paint_covered(Color color) {
        coverage_.for_each_run([this, color](const CoverageRun& run) { paint_span(run, color); });
    }

    /// A row of Pixels; `columns` has the borders between them.
    void paint_row(int y, const Color* colors, const std::vector<int>& columns) {
        const std::size_t count = columns.size() - 1;
        for (std::size_t begin = 0; begin < count;) {
            std::size_t end = begin + 1;
            while (end < count && colors[end] == colors[begin])
                ++end;
            if (colors[begin] != no_color)
                paint_span({y, columns[begin], columns[end], full_coverage}, colors[begin]);
            begin = end;
        }
    }

    static bool runs_straight(const std::vector<Place>& places) {
        return places.size() > 1 &&
               std::adjacent_find(places.begin(), places.end(), [](Place a, Place b) {
                   return a.x != b.x && a.y != b.y;
               }) == places.end();
    }

    /// The left or upper border of a line at `at`, `width` pixels wide, on whole pixels. A line on the sheet's
    /// border is within the sheet.
    static double sharp_border(double at, double width, double most) {
        const double border = std::floor(at - width / 2 + 0.5);
        return 0 <= at && at <= most ? std::clamp(border, 0.0, std::max(0.0, most - width))
                                     : border;
    }

    /// A line whose pieces run straight across or down, as boxes.
    void add_sharp(const std::vector<Place>& places, bool is_closed, double width) {
        width = std::floor(width + 0.5);
        const auto corner = [this, width](Place place) {
            return Place{sharp_border(place.x, width, width_),
                         sharp_border(place.y, width, height_)};
        };
        const std::size_t pieces = places.size() - (is_closed ? 0 : 1);
        for (std::size_t i = 0; i < pieces; ++i) {
            const Place a = corner(places[i]);
            const Place b = corner(places[(i + 1) % places.size()]);
            coverage_.add(CoveredBox{std::min(a.x, b.x), std::min(a.y, b.y),
                                     std::max(a.x, b.x) + width, std::max(a.y, b.y) + width});
        }
    }

    Bitmap& bitmap_;
    Theme theme_;
    double scale_;
    int width_;
    int height_;
    PixelCoverage coverage_;
};

} // namespace

std::optional<Problem> too_large_for_bitmap(const Drawing& drawing, double scale) {
    const double width = pixels_of(drawing.width, scale);
    const double height = pixels_of(drawing.height, scale);
    if (width * height <= static_cast<double>(most_bitmap_pixels))
        return std::nullopt;
    return problem_of("",
                      fmt::format("expected at most {} pixels in a picture, found {:.0f} x {:.0f}",
                                  most_bitmap_pixels, width, height),
                      "a smaller --scale makes it smaller; --region takes a part of it");
}

std::optional<Problem> problem_of_sides(const Bitmap& bitmap, std::size_t most,
                                        std::string_view format) {
    const std::size_t longest = std::max(bitmap.width, bitmap.height);
    if (!bitmap.colors.empty() && longest <= most)
        return std::nullopt;
    return problem_of("",
                      fmt::format("expected 1 to {} pixels a side in a {}, found {} x {}", most,
                                  format, bitmap.width, bitmap.height),
                      longest > most ? "a smaller --scale makes it smaller" : "");
}

Bitmap bitmap_of(const Drawing& drawing, Theme theme, double scale) {
    assert(!too_large_for_bitmap(drawing, scale));
    Bitmap bitmap{.width = static_cast<std::size_t>(pixels_of(drawing.width, scale)),
                  .height = static_cast<std::size_t>(pixels_of(drawing.height, scale)),
                  .title = drawing.title};
    bitmap.colors.assign(bitmap.width * bitmap.height, paint_of(Role::paper, theme).color);
    Painter painter(bitmap, theme, scale);
    for (const Shape& shape : drawing.shapes)
        std::visit([&painter](const auto& one) { painter.paint(one); }, shape);
    return bitmap;
}

} // namespace rastertrace
