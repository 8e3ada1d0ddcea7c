// SPDX-License-Identifier: MIT
// Tells a step of each kind, with all fields that docs/trace-format.md has for it. As C99, C11 and C++20.
//
//     every_step FILE

#include <rastertrace/emit.h>

static void tell_the_stages(struct rt_trace* t) {
    static const char* const corners[] = {"A", "B", "C", "D"};
    static const char* const ears[] = {"ABC", "ACD"};
    static const char* const factors[] = {"rotate", "scale"};
    static const double identity[] = {1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1};
    static const double two_identities[] = {1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1,
                                            1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1};
    static const double points[] = {0, 0, 0, 4, 0, 0, 1, 1, 0, 0, 4, 0};
    static const double up[] = {0, 0, 1};
    static const double listed[] = {2, 1};
    static const int inside[] = {1, 0, 1};

    rt_triangulate(t, "ABCD");
    rt_texts(t, "vertices", corners, 4);
    rt_rows(t, "at", points, 4, 3);
    rt_numbers(t, "normal", up, 3);
    rt_text(t, "drops", "z");
    rt_texts(t, "ears", ears, 2);

    rt_matrix(t, "model");
    rt_text(t, "object", "torus");
    rt_rows(t, "rows", identity, 4, 4);
    rt_texts(t, "factors", factors, 2);
    rt_rows(t, "factor_rows", two_identities, 8, 4);
    rt_rows(t, "camera", points, 3, 3);

    rt_vertex(t, "A", "screen");
    rt_numbers(t, "at", points, 2);
    rt_numbers(t, "snapped", points, 2);

    rt_order(t);
    rt_texts(t, "names", ears, 2);
    rt_numbers(t, "distances", listed, 2);
    rt_numbers(t, "listed", listed, 2);

    rt_face(t, "ABC", 0.5, 0);
    rt_numbers(t, "normal", up, 3);
    rt_numbers(t, "view", up, 3);
    rt_number(t, "cosine", RT_NONE);
    rt_text(t, "by", "light");
    rt_flag(t, "opposite", 1);

    rt_light(t, "ABC", 0.25);
    rt_numbers(t, "normal", up, 3);
    rt_numbers(t, "light", up, 3);
    rt_number(t, "dot", 0.25);
    rt_color(t, 255, 128, 0, 255);

    rt_clip(t, "ABC", "near");
    rt_flags(t, "inside", inside, 3);
    rt_whole(t, "out", 4);
}

static void tell_a_triangle(struct rt_trace* t) {
    static const char* const names[] = {"A", "B", "C"};
    static const char* const colors[] = {"red", "#0f0", "#0000ff80"};
    static const double at[] = {2, 5, -4, -3, 5, -3};
    static const double third[] = {1.0 / 3, 1.0 / 3, 1.0 / 3};
    static const char* const edges[] = {"AB", "AC"};
    static const double crossings[] = {-0.25, 3.125};
    static const double winding[] = {1, 0};

    rt_primitive(t, "triangle", "ABC");
    rt_texts(t, "vertices", names, 3);
    rt_rows(t, "at", at, 3, 2);
    rt_numbers(t, "depths", third, 3);
    rt_color(t, 0, 0, 0, 128);
    rt_texts(t, "colors", colors, 3);
    rt_whole(t, "octant", 1);
    rt_flag(t, "part", 1);
    rt_flag(t, "painted", 0);
    rt_whole(t, "radius", 3);
    rt_undecided(t);
    rt_text(t, "name", "ABC");
    rt_number(t, "difference", 1e-20);
    rt_number(t, "error", 1e-19);
    rt_edge(t, "BC");
    rt_number(t, "dx_dy", RT_NONE);
    rt_number(t, "a", -8);
    rt_number(t, "b", 6);
    rt_flag(t, "top_left", 1);
    rt_whole(t, "octant", 1);
    rt_half(t, "lower", -3, 5);
    rt_ray(t, 1, 2);
    rt_crossings(t, 2);
    rt_texts(t, "edges", edges, 2);
    rt_numbers(t, "x", crossings, 2);
    rt_numbers(t, "winding", winding, 2);
    rt_scanline(t, 2, -0.25, 3.125, -1, 3);
    rt_text(t, "left_edge", "AB");
    rt_text(t, "right_edge", "AC");
    rt_number(t, "left_depth", 0.1);
    rt_number(t, "right_depth", 0.2);
    rt_sample(t, 1, 2, 1);
    rt_numbers(t, "weights", third, 3);
    rt_depth(t, 1, 2, 0.125, RT_NONE, 1);
    rt_text(t, "side_of", "DEF");
    rt_depth(t, 1, 2, 0.25, 0.125, 0);
    rt_text(t, "beside", "DEF");
    rt_text(t, "behind", "DEF");
    rt_pixel(t, 1, 2);
    rt_color(t, 1, 2, 3, 255);
    rt_reject(t, "off-canvas");
    rt_whole(t, "x", 9);
    rt_whole(t, "to_x", 12);
    rt_whole(t, "y", 2);
    rt_whole(t, "to_y", 3);
    rt_skip(t, "DEF", "zero area");
    rt_primitive(t, "line", "AB");
    rt_along_x(t, 1, 2.5, 2);
    rt_along_y(t, 2, 1.5, 1);
    rt_decide(t, 1, 2, -3, "E");
}

int main(int count, char** arguments) {
    struct rt_trace trace;
    if (count < 2)
        return 2;
    rt_open(&trace, arguments[1]);
    rt_header(&trace, 17, 14, "center");
    rt_text(&trace, "title",
            "Every \"step\" \\ of\n\x01 the f\xc3\xb6rmat, \xff\xfe, \xed\xa0\x80");
    rt_text(&trace, "background", "white");
    rt_method(&trace, "convention", "opengl");
    rt_method(&trace, "scalar", "double");
    tell_the_stages(&trace);
    tell_a_triangle(&trace);
    rt_step(&trace, "tile");
    rt_whole(&trace, "tx", -9007199254740991LL);
    rt_numbers(&trace, "empty", NULL, 0);
    rt_text(&trace, "code", "shader.glsl:7"); // in place of that of the call
    if (rt_end(&trace) == 0)
        return 0;
    fprintf(stderr, "%s\n", rt_error(&trace));
    return 1;
}
