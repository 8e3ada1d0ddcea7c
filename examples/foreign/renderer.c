// SPDX-License-Identifier: MIT
// A renderer as many begin: triangles by edge functions, a sample in the center of each pixel. It reads the text that
// {triangles} stands for, and tells what it decides by emit.h: docs/your-own-rasterizer.md. It is C and C++.
//
//     cc -I trace/emit/include -o renderer examples/foreign/renderer.c
//     ./renderer scene.txt > mine.jsonl
//
// As it stands, a sample on an edge belongs to both triangles that have the edge. With -DTOP_LEFT it belongs to one.

#include <rastertrace/emit.h>

#include <stdio.h>
#include <string.h>

struct point {
    double x, y, z;
};

/// Twice the area of a triangle: positive if it runs clockwise, where y points down.
static double edge(struct point a, struct point b, struct point p) {
    return (b.x - a.x) * (p.y - a.y) - (b.y - a.y) * (p.x - a.x);
}

/// True if a sample is on the inner side of an edge.
static int covers(struct point a, struct point b, struct point p) {
    const double e = edge(a, b, p);
#ifdef TOP_LEFT
    const int is_top_left = b.y < a.y || (b.y == a.y && b.x > a.x);
    return e > 0 || (e == 0 && is_top_left);
#else
    return e >= 0;
#endif
}

static void fill(struct rt_trace* trace, struct point v[3], int width, int height) {
    if (edge(v[0], v[1], v[2]) < 0) { // the other way round
        const struct point second = v[1];
        v[1] = v[2];
        v[2] = second;
    }
    if (edge(v[0], v[1], v[2]) == 0)
        return;
    for (int y = 0; y < height; ++y)
        for (int x = 0; x < width; ++x) {
            const struct point p = {x + 0.5, y + 0.5, 0};
            if (covers(v[1], v[2], p) && covers(v[2], v[0], p) && covers(v[0], v[1], p))
                rt_pixel(trace, x, y);
        }
}

int main(int count, char** arguments) {
    FILE* const scene = count > 1 ? fopen(arguments[1], "r") : NULL;
    int width = 0, height = 0;
    char word[8], name[32];
    struct rt_trace trace;
    if (scene == NULL || fscanf(scene, "canvas %d %d", &width, &height) != 2)
        return 2;
    rt_open_file(&trace, stdout);
    rt_header(&trace, width, height, "top-left");
    rt_method(&trace, "fill", "top-left");
    rt_method(&trace, "sample", "center");
    while (fscanf(scene, "%7s %31s", word, name) == 2) {
        struct point v[3];
        double at[6];
        unsigned color;
        for (int i = 0; i < 3; ++i) {
            if (fscanf(scene, "%lf %lf %lf", &v[i].x, &v[i].y, &v[i].z) != 3)
                return 2;
            at[2 * i] = v[i].x;
            at[2 * i + 1] = v[i].y;
        }
        rt_primitive(&trace, "triangle", name);
        rt_rows(&trace, "at", at, 3, 2);
        if (fscanf(scene, " #%6x", &color) == 1)
            rt_color(&trace, (int)(color >> 16), (int)(color >> 8 & 255), (int)(color & 255), 255);
        fill(&trace, v, width, height);
    }
    fclose(scene);
    if (rt_end(&trace) == 0)
        return 0;
    fprintf(stderr, "%s\n", rt_error(&trace));
    return 3;
}
