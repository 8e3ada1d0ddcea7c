// SPDX-License-Identifier: MIT
#include "frames/terminal_text.h"

#include "app/environment.h"

#include <rastertrace/trace/text/color_text.h>
#include <rastertrace/trace/text/text.h>

#include <fmt/core.h>

#include <sys/ioctl.h>
#include <unistd.h>

#include <array>
#include <charconv>
#include <cstddef>
#include <limits>
#include <string_view>
#include <vector>

namespace rastertrace {

namespace {

/// The number of the palette's color that is nearest, of those that `color_of(number)` gives.
template <std::size_t count>
std::size_t nearest_color(Color color, const std::array<Color, count>& palette) {
    std::size_t nearest = 0;
    int least = std::numeric_limits<int>::max();
    for (std::size_t i = 0; i < count; ++i) {
        const int red = color.red() - palette[i].red();
        const int green = color.green() - palette[i].green();
        const int blue = color.blue() - palette[i].blue();
        const int distance = red * red + green * green + blue * blue;
        if (distance < least) {
            least = distance;
            nearest = i;
        }
    }
    return nearest;
}

/// The 16 colors of a terminal, as xterm shows them.
constexpr std::array<Color, 16> ansi_palette{{{0, 0, 0},
                                              {205, 0, 0},
                                              {0, 205, 0},
                                              {205, 205, 0},
                                              {0, 0, 238},
                                              {205, 0, 205},
                                              {0, 205, 205},
                                              {229, 229, 229},
                                              {127, 127, 127},
                                              {255, 0, 0},
                                              {0, 255, 0},
                                              {255, 255, 0},
                                              {92, 92, 255},
                                              {255, 0, 255},
                                              {0, 255, 255},
                                              {255, 255, 255}}};

/// The part of a 256-color cube that a level of a channel belongs to: 0, 95, 135, ..., 255.
int cube_level(std::uint8_t level) {
    return level < 48 ? 0 : level < 115 ? 1 : (level - 35) / 40;
}

constexpr int foreground = 38; ///< Select Graphic Rendition (ECMA-48 8.3.117): the color of signs
constexpr int background = 48; ///< ... and of what is behind them

/// The codes of a color.
std::string code_of(Color color, int ground, ColorDepth colors) {
    switch (colors) {
    case ColorDepth::truecolor:
        return fmt::format("{};2;{};{};{}", ground, color.red(), color.green(), color.blue());
    case ColorDepth::palette256:
        return fmt::format("{};5;{}", ground,
                           16 + 36 * cube_level(color.red()) + 6 * cube_level(color.green()) +
                               cube_level(color.blue()));
    case ColorDepth::ansi16: {
        const std::size_t nearest = nearest_color(color, ansi_palette);
        const auto first =
            static_cast<std::size_t>(ground - 8); // 30 or 40; the light ones begin 60 later
        return std::to_string(nearest < 8 ? first + nearest : first + 60 + nearest - 8);
    }
    case ColorDepth::none:
        break;
    }
    return {};
}

/// A size from the environment; `otherwise` if it is not set or makes no sense.
std::size_t from_environment(const char* name, std::size_t otherwise) {
    std::size_t value = 0;
    const std::string_view digits = environment_variable(name);
    const auto read = std::from_chars(digits.data(), digits.data() + digits.size(), value);
    const bool is_number = read.ec == std::errc{} && read.ptr == digits.data() + digits.size();
    return is_number && value > 0 ? value : otherwise;
}

} // namespace

ColorDepth output_colors(ColorChoice choice) {
    const std::string_view terminal = environment_variable("TERM");
    if (choice == ColorChoice::never)
        return ColorDepth::none;
    if (choice == ColorChoice::automatic &&
        (::isatty(STDOUT_FILENO) == 0 || terminal.empty() || terminal == "dumb" ||
         !environment_variable("NO_COLOR").empty()))
        return ColorDepth::none;
    const std::string_view depth = environment_variable("COLORTERM");
    if (depth == "truecolor" || depth == "24bit")
        return ColorDepth::truecolor;
    return terminal.find("256color") != std::string_view::npos ? ColorDepth::palette256
                                                               : ColorDepth::ansi16;
}

bool output_has_unicode() {
    for (const char* const name : {"LC_ALL", "LC_CTYPE", "LANG"})
        if (const std::string_view locale = environment_variable(name); !locale.empty())
            return locale.find("UTF-8") != std::string_view::npos ||
                   locale.find("utf8") != std::string_view::npos;
    return false;
}

TextSize output_size() {
    winsize window{};
    if (::isatty(STDOUT_FILENO) != 0 && ::ioctl(STDOUT_FILENO, TIOCGWINSZ, &window) == 0 &&
        window.ws_col > 0 && window.ws_row > 0)
        return {window.ws_col, window.ws_row};
    const TextSize unlimited;
    return {from_environment("COLUMNS", unlimited.columns),
            from_environment("LINES", unlimited.lines)};
}

std::string in_lower_case(std::string text) {
    for (char& c : text)
        if ('A' <= c && c <= 'Z')
            c = static_cast<char>(c - 'A' + 'a');
    return text;
}

std::string styled(std::string_view text, const Style& style, ColorDepth colors) {
    if (colors == ColorDepth::none)
        return std::string(text);
    if (style.is_cursor)
        return fmt::format("\x1b[30;103m{}\x1b[0m", text);
    std::vector<std::string> codes;
    if (style.foreground)
        codes.push_back(code_of(*style.foreground, foreground, colors));
    else if (style.background)
        codes.emplace_back(is_light(*style.background) ? "30" : "97");
    if (style.background)
        codes.push_back(code_of(*style.background, background, colors));
    if (style.is_reversed)
        codes.emplace_back("7");
    if (style.is_strong)
        codes.emplace_back("1");
    if (style.is_quiet)
        codes.emplace_back("2");
    return codes.empty() ? std::string(text)
                         : fmt::format("\x1b[{}m{}\x1b[0m", joined(codes, ";"), text);
}

} // namespace rastertrace
