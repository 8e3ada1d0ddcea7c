// SPDX-License-Identifier: MIT
#include "font.h"

#include "font_parts.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <new>

// Memory that is not there ends the figure: by itself, stb leaves a letter out.
#define STBTT_malloc(size, user) ((void)(user), ::operator new(size))
#define STBTT_free(memory, user) ((void)(user), ::operator delete(memory))
#define STBTT_STATIC
#define STB_TRUETYPE_IMPLEMENTATION
#include <stb/stb_truetype.h>

namespace rastertrace {

namespace {

/// Units of the font: all heights are measured in them, from the line that letters stand on.
constexpr double units_per_em = 2048;

stbtt_fontinfo font_in(const unsigned char* file) {
    stbtt_fontinfo font{};
    stbtt_InitFont(&font, file, 0);
    return font;
}

const stbtt_fontinfo& font_of(Typeface face) {
    static const std::array fonts{font_in(DejaVuSans_ttf), font_in(DejaVuSans_Bold_ttf),
                                  font_in(DejaVuSansMono_ttf)};
    return fonts[static_cast<std::size_t>(face)];
}

/// Puts heights on whole pixels: the foot of letters, the top of an x, and that of an H. What a round letter has
/// beyond these is left out, else it would be a faint row of pixels.
class Heights {
public:
    explicit Heights(double pixels_per_unit)
        : scale_(pixels_per_unit), small_(std::floor(x_height * scale_ + 0.5)),
          capital_(std::floor(capital_height * scale_ + 0.5)) {}

    /// In pixels, upward.
    double fitted(double y) const {
        if (y <= -overshoot)
            return (y + overshoot) * scale_;
        if (y <= x_height)
            return std::max(y, 0.0) / x_height * small_;
        if (y <= x_height + overshoot)
            return small_;
        if (y <= capital_height) {
            const double begin = x_height + overshoot;
            return small_ + (y - begin) / (capital_height - begin) * (capital_ - small_);
        }
        return capital_ + std::max(y - ascender, 0.0) * scale_;
    }

private:
    static constexpr double overshoot = 29;
    static constexpr double x_height = 1120;
    static constexpr double capital_height = 1493;
    static constexpr double ascender = 1556;

    double scale_;
    double small_;
    double capital_;
};

/// Adds a quadratic curve from the path's last place on, as pieces that are a 16th of a pixel away from it at most.
void add_curve(Place control, Place to, Path& path) {
    const Place from = path.back();
    const double away_x =
        (from.x - 2 * control.x + to.x) / 4; // of the chord's middle from the curve
    const double away_y = (from.y - 2 * control.y + to.y) / 4;
    constexpr double pieces_per_pixel = 16;
    const double pieces =
        std::ceil(std::sqrt(pieces_per_pixel * std::sqrt(away_x * away_x + away_y * away_y)));
    for (double piece = 1; piece < pieces; ++piece) {
        const double t = piece / pieces;
        const auto at = [t](double a, double b, double c) {
            return (1 - t) * (1 - t) * a + 2 * t * (1 - t) * b + t * t * c;
        };
        path.push_back({at(from.x, control.x, to.x), at(from.y, control.y, to.y)});
    }
    path.push_back(to);
}

int units_to_next(const stbtt_fontinfo& font, int glyph) {
    int advance = 0;
    stbtt_GetGlyphHMetrics(&font, glyph, &advance, nullptr);
    return advance;
}

} // namespace

std::optional<double> advance_of(char32_t character, Typeface face) {
    const stbtt_fontinfo& font = font_of(face);
    const int glyph = stbtt_FindGlyphIndex(&font, static_cast<int>(character));
    if (glyph == 0)
        return std::nullopt;
    return units_to_next(font, glyph) / units_per_em;
}

Outline outline_of(char32_t character, Typeface face, double size) {
    const stbtt_fontinfo& font = font_of(face);
    const int glyph = stbtt_FindGlyphIndex(&font, static_cast<int>(character));
    const double scale = size / units_per_em;
    const Heights heights(scale);
    const auto place = [&](short x, short y) { return Place{x * scale, -heights.fitted(y)}; };

    Outline outline{.advance = units_to_next(font, glyph) * scale};
    stbtt_vertex* vertices = nullptr;
    const int count = stbtt_GetGlyphShape(&font, glyph, &vertices);
    for (int i = 0; i < count; ++i) {
        const stbtt_vertex& vertex = vertices[i]; // NOLINT: an array of C
        const Place at = place(vertex.x, vertex.y);
        if (vertex.type == STBTT_vmove)
            outline.contours.push_back({at});
        else if (vertex.type == STBTT_vline)
            outline.contours.back().push_back(at);
        else
            add_curve(place(vertex.cx, vertex.cy), at, outline.contours.back());
    }
    stbtt_FreeShape(&font, vertices);
    return outline;
}

} // namespace rastertrace
