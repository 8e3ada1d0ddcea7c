// SPDX-License-Identifier: MIT
// Writes the pixels of 20 drawings to standard output, for clang/same_bitmaps.sh to compare between compilers: all
// shapes, all letters, and random lines, dashes and polygons.

#include "figures/hostile_drawing.h"

#include <rastertrace/figures/bitmap.h>

#include <cstdio>
#include <random>

namespace {

using namespace rastertrace;

Drawing random_drawing(unsigned seed) {
    std::mt19937 random(seed);
    const auto number = [&random](double least, double most) {
        return least + (most - least) * (static_cast<double>(random()) / 4294967296.0);
    };
    Drawing drawing{.width = 300, .height = 200, .title = "random"};
    for (int i = 0; i < 20; ++i) {
        Path path;
        for (int k = 0; k < 5; ++k)
            path.push_back({number(-50, 350), number(-50, 250)});
        const Role role = roles()[random() % roles().size()];
        if (i % 3 == 0)
            drawing.shapes.push_back(Polygons{.role = role, .paths = {path}});
        else
            drawing.shapes.push_back(
                Lines{.role = role, .paths = {path}, .are_closed = i % 2 == 0});
        drawing.shapes.push_back(
            Dots{.role = role, .radius = number(0.3, 9), .centers = {path[0], path[1]}});
        drawing.shapes.push_back(Label{.role = role,
                                       .at = path[2],
                                       .text = "Row 12: x = -25/8",
                                       .size = number(6, 30),
                                       .is_bold = i % 5 == 0,
                                       .is_turned = i % 7 == 0,
                                       .has_rim = i % 4 == 0});
    }
    return drawing;
}

void write(const Drawing& drawing, double scale) {
    for (const Color color : bitmap_of(drawing, Theme::light, scale).colors) {
        std::putchar(color.red());
        std::putchar(color.green());
        std::putchar(color.blue());
    }
}

} // namespace

int main() {
    for (const double scale : {1.0, 1.7}) {
        write(hostile_drawing(), scale);
        for (unsigned seed = 0; seed < 9; ++seed)
            write(random_drawing(seed), scale);
    }
}
