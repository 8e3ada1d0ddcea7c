// SPDX-License-Identifier: MIT
// Writes pictures for tikz.sh into the folder that is named: texts that TeX must not obey, and as much as a picture
// may hold.

#include "figures/hostile_drawing.h"

#include <rastertrace/figures/tikz.h>

#include <cstdio>
#include <fstream>
#include <string>

namespace {

using namespace rastertrace;

bool write(const Drawing& drawing, double width_mm, const std::string& path) {
    const auto tex = tikz_of(drawing, Theme::light, width_mm);
    if (!tex) {
        std::fprintf(stderr, "%s: %s\n", path.c_str(), to_text(tex.problem()).c_str());
        return false;
    }
    return static_cast<bool>(std::ofstream(path) << tex.value() << std::flush);
}

Drawing full(const Shape& shape) {
    Drawing drawing{.width = 400, .height = 400, .title = "As much as fits"};
    drawing.shapes.push_back(shape);
    return drawing;
}

Drawing of_rectangles() {
    Pixels pixels{.corner = {0, 0}, .side = 2, .columns = 200};
    for (std::size_t i = 0; i < most_tikz_places / 2; ++i)
        pixels.colors.push_back({static_cast<std::uint8_t>(i % 251), 0, 0});
    return full(pixels);
}

Drawing of_lines() {
    Path path;
    for (std::size_t i = 0; i < most_tikz_places; ++i)
        path.push_back({static_cast<double>(i % 400), static_cast<double>(i * 7 % 397)});
    return full(Lines{.paths = {path}});
}

Drawing of_dots() {
    Dots dots{.role = Role::sample, .radius = 1};
    for (std::size_t i = 0; i < most_tikz_places / 4; ++i)
        dots.centers.push_back({static_cast<double>(i % 400), static_cast<double>(i / 400 * 5)});
    return full(dots);
}

Drawing of_labels() {
    Drawing drawing{.width = 400, .height = 400, .title = "Labels"};
    for (std::size_t i = 0; i < most_tikz_places / 20; ++i)
        drawing.shapes.push_back(Label{.at = {static_cast<double>(i % 400), 200},
                                       .text = "Row 12 of a label",
                                       .has_rim = true});
    return drawing;
}

} // namespace

int main(int argc, char** argv) {
    if (argc != 2)
        return 2;
    const std::string folder = argv[1]; // NOLINT: main has pointers
    const bool is_written = write(hostile_drawing(), 90, folder + "/hostile.tex") &&
                            write(of_rectangles(), 100, folder + "/rectangles.tex") &&
                            write(of_lines(), 100, folder + "/lines.tex") &&
                            write(of_dots(), 100, folder + "/dots.tex") &&
                            write(of_labels(), 100, folder + "/labels.tex");
    return is_written ? 0 : 3;
}
