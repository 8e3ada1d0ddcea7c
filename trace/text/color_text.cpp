// SPDX-License-Identifier: MIT
#include "color_text.h"

#include <fmt/core.h>

#include <array>
#include <charconv>
#include <cmath>
#include <cstdint>
#include <utility>

namespace rastertrace {

namespace {

/// The color keywords of CSS 2.1, section 4.3.6: those of HTML 4, and orange.
constexpr std::array<std::pair<std::string_view, Color>, 17> basic_colors{{
    {"black", {0x00, 0x00, 0x00, 255}},
    {"silver", {0xC0, 0xC0, 0xC0, 255}},
    {"gray", {0x80, 0x80, 0x80, 255}},
    {"white", {0xFF, 0xFF, 0xFF, 255}},
    {"maroon", {0x80, 0x00, 0x00, 255}},
    {"red", {0xFF, 0x00, 0x00, 255}},
    {"purple", {0x80, 0x00, 0x80, 255}},
    {"fuchsia", {0xFF, 0x00, 0xFF, 255}},
    {"green", {0x00, 0x80, 0x00, 255}},
    {"lime", {0x00, 0xFF, 0x00, 255}},
    {"olive", {0x80, 0x80, 0x00, 255}},
    {"yellow", {0xFF, 0xFF, 0x00, 255}},
    {"navy", {0x00, 0x00, 0x80, 255}},
    {"blue", {0x00, 0x00, 0xFF, 255}},
    {"teal", {0x00, 0x80, 0x80, 255}},
    {"aqua", {0x00, 0xFF, 0xFF, 255}},
    {"orange", {0xFF, 0xA5, 0x00, 255}},
}};

/// The share of light of an sRGB channel, 0 to 1.
double light_of(std::uint8_t level) {
    const double share = level / 255.0;
    return share <= 0.04045 ? share / 12.92 : std::pow((share + 0.055) / 1.055, 2.4);
}

} // namespace

std::optional<Color> parse_color(std::string_view text) {
    for (const auto& [name, color] : basic_colors)
        if (name == text)
            return color;

    if (!text.starts_with('#'))
        return std::nullopt;
    // Each digit of #rgb counts twice.
    if (text.size() == 4)
        return parse_color(fmt::format("#{0}{0}{1}{1}{2}{2}", text[1], text[2], text[3]));
    if (text.size() != 7 && text.size() != 9)
        return std::nullopt;
    std::array<std::uint8_t, 4> channels{0, 0, 0, 255};
    for (std::size_t i = 0; 2 * i + 1 < text.size(); ++i) {
        const char* const digits = text.data() + 1 + 2 * i;
        unsigned value = 0;
        const auto [end, error] = std::from_chars(digits, digits + 2, value, 16);
        if (error != std::errc{} || end != digits + 2)
            return std::nullopt;
        channels[i] = static_cast<std::uint8_t>(value);
    }
    return Color{channels[0], channels[1], channels[2], channels[3]};
}

std::string to_text(Color color) {
    constexpr std::string_view digits = "0123456789abcdef";
    std::string text = "#";
    for (const unsigned level : {color.red(), color.green(), color.blue(), color.alpha()}) {
        text += digits[level / 16];
        text += digits[level % 16];
    }
    if (color.alpha() == 255)
        text.resize(7);
    return text;
}

std::vector<std::string_view> color_names() {
    std::vector<std::string_view> names;
    for (const auto& [name, color] : basic_colors)
        names.push_back(name);
    return names;
}

double luminance(Color color) {
    return 0.2126 * light_of(color.red()) + 0.7152 * light_of(color.green()) +
           0.0722 * light_of(color.blue());
}

bool is_light(Color color) {
    return luminance(color) > 0.179;
}

} // namespace rastertrace
