// SPDX-License-Identifier: MIT
// A rasterizer in C that knows of rastertrace one header, and tells by it what it decides: docs/regression-tests.md.
// triangle.py, triangle.mjs and triangle.rs tell the same.
//
//     cc -I trace/emit/include -o triangle examples/foreign/triangle.c -lm
//     ./triangle triangle.jsonl

#include <rastertrace/emit.h>

#include <math.h>

struct vertex {
    const char* name;
    double x, y; // y points up
};

/// Fills a row from one edge to another.
static void fill_row(struct rt_trace* trace, int y, const double ends[2], const char edges[2][3]) {
    const int from = (int)floor(ends[0]), to = (int)floor(ends[1]);
    rt_scanline(trace, y, ends[0], ends[1], from, to);
    rt_text(trace, "left_edge", edges[0]);
    rt_text(trace, "right_edge", edges[1]);
    for (int x = from; x <= to; ++x)
        rt_pixel(trace, x, y);
}

/// Goes down from the highest row to the lowest, from edge to edge.
static void fill_triangle(struct rt_trace* trace, const struct vertex corners[3]) {
    const double high = fmax(corners[0].y, fmax(corners[1].y, corners[2].y));
    const double low = fmin(corners[0].y, fmin(corners[1].y, corners[2].y));
    for (int y = (int)floor(high); y >= low; --y) {
        double ends[2] = {INFINITY, -INFINITY};
        char edges[2][3] = {"", ""};
        for (int i = 0; i < 3; ++i) {
            // The upper vertex comes first, in the edge's name too.
            const struct vertex a = corners[i], b = corners[(i + 1) % 3];
            const struct vertex upper = a.y > b.y ? a : b, lower = a.y > b.y ? b : a;
            if (y > upper.y || y < lower.y || upper.y == lower.y)
                continue;
            const double x = upper.x + (upper.x - lower.x) / (upper.y - lower.y) * (y - upper.y);
            const char edge[3] = {upper.name[0], lower.name[0], '\0'};
            if (x < ends[0]) {
                ends[0] = x;
                memcpy(edges[0], edge, sizeof edge);
            }
            if (x > ends[1] || (x == ends[1] && strcmp(edge, edges[0]) != 0)) {
                ends[1] = x;
                memcpy(edges[1], edge, sizeof edge);
            }
        }
        fill_row(trace, y, ends, (const char(*)[3])edges);
    }
}

int main(int count, char** arguments) {
    const struct vertex corners[3] = {{"A", 2, 5}, {"B", -4, -3}, {"C", 5, -3}};
    const char* const names[3] = {"A", "B", "C"};
    const double at[6] = {2, 5, -4, -3, 5, -3};
    struct rt_trace trace;
    if (count > 1)
        rt_open(&trace, arguments[1]);
    else
        rt_open_file(&trace, stdout);
    rt_header(&trace, 17, 14, "center");
    rt_text(&trace, "title", "Mine");
    rt_method(&trace, "scalar", "double");
    rt_method(&trace, "fill", "scanline");
    rt_method(&trace, "rounding", "floor");
    rt_primitive(&trace, "triangle", "ABC");
    rt_texts(&trace, "vertices", names, 3);
    rt_rows(&trace, "at", at, 3, 2);
    rt_color(&trace, 0, 0, 0, 255);
    fill_triangle(&trace, corners);
    if (rt_end(&trace) == 0)
        return 0;
    fprintf(stderr, "%s\n", rt_error(&trace));
    return 3;
}
