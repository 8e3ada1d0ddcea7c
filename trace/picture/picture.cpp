// SPDX-License-Identifier: MIT
#include "picture.h"

#include "readers.h"

#include <fmt/core.h>

#include <algorithm>
#include <string_view>

namespace rastertrace {

namespace {

using namespace std::string_view_literals;

bool has_ending_of_tga(std::string_view name) {
    constexpr std::string_view ending = ".tga";
    return name.size() >= ending.size() &&
           std::equal(ending.begin(), ending.end(), name.end() - ending.size(),
                      [](char small, char c) { return c == small || (c | 0x20) == small; });
}

} // namespace

Picture blank_picture(const Source& source, std::size_t width, std::size_t height) {
    constexpr std::size_t longest = largest_canvas_side;
    if (width < 1 || height < 1 || width > longest || height > longest ||
        width * height > largest_canvas_area)
        throw problem_of(source.name,
                         fmt::format("expected 1 to {} pixels a side and at most {} in all, "
                                     "found {} x {}",
                                     longest, largest_canvas_area, width, height));
    return {static_cast<int>(width), static_cast<int>(height), Colors(width * height)};
}

void check_rows(const Source& source, int expected, std::size_t found) {
    if (found < static_cast<std::size_t>(expected))
        throw problem_of(source.name, fmt::format("expected {} rows, found {} and then the end",
                                                  expected, found));
}

std::optional<PictureFormat> picture_format(const Source& source) {
    const std::string_view bytes = source.view();
    if (bytes.starts_with("\x89PNG\r\n\x1A\n"))
        return PictureFormat::png;
    if (bytes.size() >= 3 && bytes[0] == 'P' && '1' <= bytes[1] && bytes[1] <= '6' &&
        " \t\r\n#"sv.find(bytes[2]) != std::string_view::npos)
        return PictureFormat::pnm;
    if (bytes.ends_with("TRUEVISION-XFILE.\0"sv) || has_ending_of_tga(source.name))
        return PictureFormat::tga;
    if (begins_with_text_row(bytes))
        return PictureFormat::text_rows;
    return std::nullopt;
}

Result<Picture> read_picture(const Source& source) {
    const auto format = picture_format(source);
    if (!format)
        return problem_of(source.name, "expected a picture (PNG, PPM, PGM, PBM, TGA, or rows of "
                                       "text), found something else");
    try {
        switch (*format) {
        case PictureFormat::png:
            return read_png(source);
        case PictureFormat::pnm:
            return read_pnm(source);
        case PictureFormat::tga:
            return read_tga(source);
        case PictureFormat::text_rows:
            break;
        }
        return read_text_rows(source);
    } catch (const Problem& problem) {
        return problem;
    }
}

} // namespace rastertrace
