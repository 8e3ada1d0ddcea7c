// SPDX-License-Identifier: MIT
// A translation unit of its own, in C; parts.cpp is the other one.
#include "tile.h"

void draw_tile(struct rt_trace* part, int triangles, int is_right) {
    char name[16];
    for (int number = 0; number < triangles; ++number) {
        rt_primitive_number(part, number);
        snprintf(name, sizeof name, "t%d", number);
        if (number % 3 == 0 && is_right) {
            continue; // in the left half alone
        } else if (number % 3 == 1) {
            rt_skip(part, name,
                    is_right ? "right" : "left"); // a step without its primitive, in both
            continue;
        }
        rt_primitive(part, "triangle", name);
        for (int x = 0; x < number % 50; ++x)
            rt_pixel(part, (is_right ? 100 : 0) + x, number);
    }
}
