// SPDX-License-Identifier: MIT
#include "picture_trace.h"

#include <rastertrace/trace/text/color_text.h>

#include <fmt/core.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <unordered_map>

namespace rastertrace {

namespace {

/// Calls `use` with column and row of each pixel that is drawn, from the top.
template <typename Use> void for_drawn_pixels(const Picture& picture, const Use& use) {
    const Color background = background_of(picture);
    for (int row = 0; row < picture.height; ++row)
        for (int x = 0; x < picture.width; ++x)
            if (const Color color = picture.at(x, row); color.alpha() != 0 && color != background)
                use(x, row);
}

} // namespace

Color most_frequent(const std::vector<Color>& colors) {
    std::unordered_map<std::uint32_t, std::size_t> count;
    Color most = no_color;
    std::size_t largest = 0;
    for (const Color& color : colors) {
        const std::uint32_t key = static_cast<std::uint32_t>(color.red()) << 24U |
                                  static_cast<std::uint32_t>(color.green()) << 16U |
                                  static_cast<std::uint32_t>(color.blue()) << 8U | color.alpha();
        if (const std::size_t now = ++count[key]; now > largest) {
            largest = now;
            most = color;
        }
    }
    return most;
}

bool has_background(const Picture& picture) {
    const auto is_transparent = [](const Color& color) { return color.alpha() == 0; };
    return picture.has_colors && std::ranges::none_of(picture.pixels, is_transparent);
}

Color background_of(const Picture& picture) {
    if (!has_background(picture))
        return no_color;
    std::vector<Color> border;
    for (int x = 0; x < picture.width; ++x)
        border.insert(border.end(), {picture.at(x, 0), picture.at(x, picture.height - 1)});
    for (int row = 0; row < picture.height; ++row)
        border.insert(border.end(), {picture.at(0, row), picture.at(picture.width - 1, row)});
    return most_frequent(border);
}

Color background_beside(const Picture& picture, std::optional<Color> said,
                        const std::function<bool(int x, int row)>& is_drawn) {
    if (!has_background(picture))
        return no_color;
    if (said)
        return *said;
    std::vector<Color> not_drawn;
    for (int row = 0; row < picture.height; ++row)
        for (int x = 0; x < picture.width; ++x)
            if (!is_drawn(x, row))
                not_drawn.push_back(picture.at(x, row));
    return most_frequent(not_drawn);
}

std::string picture_trace(const Picture& picture) {
    std::string text =
        fmt::format(R"({{"rastertrace":1,"canvas":{{"width":{},"height":{},"origin":"top-left"}}}})"
                    "\n",
                    picture.width, picture.height);
    std::size_t steps = 0;
    for_drawn_pixels(picture, [&](int x, int row) {
        text += fmt::format(R"({{"step":"pixel","x":{},"y":{})", x, row);
        if (picture.has_colors)
            text += fmt::format(R"(,"color":"{}")", to_text(picture.at(x, row)));
        text += "}\n";
        ++steps;
    });
    return text + fmt::format(R"({{"end":{{"steps":{}}}}})"
                              "\n",
                              steps);
}

std::vector<std::string> picture_rows(const Picture& picture) {
    std::vector<std::string> rows(static_cast<std::size_t>(picture.height),
                                  std::string(static_cast<std::size_t>(picture.width), '.'));
    for_drawn_pixels(picture, [&rows](int x, int row) {
        rows[static_cast<std::size_t>(row)][static_cast<std::size_t>(x)] = '#';
    });
    return rows;
}

} // namespace rastertrace
