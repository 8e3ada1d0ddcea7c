// SPDX-License-Identifier: MIT
// A rasterizer that `rastertrace fuzz` drives: triangles by edge functions with the top-left rule, samples in pixel
// centers, depths linear on the screen; lines by Bresenham's algorithm; all in whole numbers. It reads the text that
// {triangles} stands for, and prints its trace. With a number, it has the mistake of that number; with `depth`, it has
// a depth buffer; with `rgb`, it prints a picture instead, with `bgr` one whose channels are exchanged, with `white` one
// without the colors of the scene.
//
//     rasterizer scene.txt 16 depth rgb

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <iostream>
#include <sstream>
#include <string>
#include <thread>
#include <vector>

namespace {

constexpr std::int64_t one = 1024; ///< coordinates are k/1024
constexpr std::int64_t half = one / 2;

int mistake = 0;
int width = 0;
int height = 0;
int steps = 0;

/// The picture, if it is asked for: its kind, and the colors of its pixels.
std::string picture_kind;
std::vector<unsigned> picture;
unsigned color = 0;

using Vertex = std::array<std::int64_t, 3>;

/// The depth of a pixel, a fraction: `above` / `below`.
struct Depth {
    __int128 above = 0;
    __int128 below = 0; ///< 0: nothing yet
};
std::vector<Depth> depths;

std::int64_t floor_of(std::int64_t value) {
    return value >= 0 ? value / one : -((-value + one - 1) / one);
}

void plot(std::int64_t x, std::int64_t y) {
    if (x < 0 || y < 0 || x >= width || y >= height)
        return;
    if (!picture_kind.empty()) {
        picture[static_cast<std::size_t>(y * width + x)] = color;
        return;
    }
    std::printf("{\"step\":\"pixel\",\"x\":%d,\"y\":%d}\n", static_cast<int>(x),
                static_cast<int>(y));
    ++steps;
}

void begin(const char* kind, const std::string& name) {
    if (!picture_kind.empty())
        return;
    std::printf("{\"step\":\"primitive\",\"kind\":\"%s\",\"name\":\"%s\"}\n", kind, name.c_str());
    ++steps;
}

/// The same in floats.
float float_area(const Vertex& a, const Vertex& b, const Vertex& c) {
    const auto in = [](std::int64_t value) { return static_cast<float>(value) / one; };
    return (in(b[0]) - in(a[0])) * (in(c[1]) - in(a[1])) -
           (in(b[1]) - in(a[1])) * (in(c[0]) - in(a[0]));
}

/// Twice the area of a triangle, positive if it runs clockwise where y points down.
std::int64_t area(const Vertex& a, const Vertex& b, const Vertex& c) {
    if (mistake == 21)
        return static_cast<std::int64_t>(float_area(a, b, c) * one * one);
    return (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0]);
}

/// True of an edge on the top or on the left of such a triangle.
bool is_top_left(const Vertex& a, const Vertex& b) {
    if (mistake == 1) // a horizontal edge is top wherever it is
        return b[1] < a[1] || b[1] == a[1];
    if (mistake == 2) // bottom right
        return b[1] > a[1] || (b[1] == a[1] && b[0] < a[0]);
    return b[1] < a[1] || (b[1] == a[1] && b[0] > a[0]);
}

bool is_inside(std::int64_t edge, const Vertex& a, const Vertex& b) {
    if (mistake == 3) // both triangles take what lies on their edge
        return edge >= 0;
    if (mistake == 4) // neither takes it
        return edge > 0;
    if (mistake == 5) // an epsilon
        return edge > -one * 8;
    return edge > 0 || (edge == 0 && is_top_left(a, b));
}

bool passes(std::size_t place, const Depth& depth) {
    Depth& stored = depths[place];
    const __int128 here = depth.above * stored.below;
    const __int128 there = stored.above * depth.below;
    const bool is_nearer = mistake == 15   ? here > there
                           : mistake == 16 ? here <= there
                                           : here < there;
    if (stored.below != 0 && !is_nearer)
        return false;
    if (mistake != 17) // what passes is not stored
        stored = depth;
    return true;
}

void fill(std::array<Vertex, 3> v, bool has_depth) {
    if (mistake == 6) // vertices are snapped to pixels
        for (Vertex& one_of : v)
            for (std::size_t axis = 0; axis < 2; ++axis)
                one_of[axis] = floor_of(one_of[axis] + half) * one;
    if (mistake == 7) // only those that run clockwise are drawn
        if (area(v[0], v[1], v[2]) < 0)
            return;
    if (mistake == 8) // those that are far away overflow
        for (Vertex& one_of : v)
            for (std::size_t axis = 0; axis < 2; ++axis)
                one_of[axis] = static_cast<std::int16_t>(one_of[axis] / 16) * std::int64_t{16};
    if (area(v[0], v[1], v[2]) < 0)
        std::swap(v[1], v[2]);
    const std::int64_t all = area(v[0], v[1], v[2]);
    if (all == 0)
        return;
    const auto [least_x, most_x] = std::minmax({v[0][0], v[1][0], v[2][0]});
    const auto [least_y, most_y] = std::minmax({v[0][1], v[1][1], v[2][1]});
    const std::int64_t left = std::max<std::int64_t>(0, floor_of(least_x));
    const std::int64_t right =
        std::min<std::int64_t>(width - 1, floor_of(most_x) - (mistake == 9 ? 1 : 0));
    const std::int64_t top = std::max<std::int64_t>(mistake == 10 ? 1 : 0, floor_of(least_y));
    const std::int64_t bottom = std::min<std::int64_t>(height - 1, floor_of(most_y));
    for (std::int64_t y = top; y <= bottom; ++y)
        for (std::int64_t x = left; x <= right; ++x) {
            const std::int64_t to_sample = mistake == 11 ? 0 : half; // corners instead of centers
            const Vertex p{x * one + to_sample, y * one + (mistake == 12 ? half - 1 : to_sample),
                           0};
            const std::int64_t e0 = area(v[1], v[2], p);
            const std::int64_t e1 = area(v[2], v[0], p);
            const std::int64_t e2 = area(v[0], v[1], p);
            if (!is_inside(e0, v[1], v[2]) || !is_inside(e1, v[2], v[0]) ||
                !is_inside(e2, v[0], v[1]))
                continue;
            // The weights of the corners, permuted.
            const bool is_permuted = mistake == 18;
            const Depth depth{static_cast<__int128>(is_permuted ? e1 : e0) * v[0][2] +
                                  static_cast<__int128>(is_permuted ? e0 : e1) * v[1][2] +
                                  static_cast<__int128>(e2) * v[2][2],
                              all};
            if (!has_depth || passes(static_cast<std::size_t>(y * width + x), depth))
                plot(x, y);
        }
    if (mistake == 13 && all < half * half) // a small one never ends
        for (;;)
            std::this_thread::yield();                // a loop that does nothing may be left out
    if (mistake == 14 && most_x - least_x > 40 * one) // a wide one ends the program
        std::abort();
}

/// From the first pixel to the last; at d = 0 it goes straight on.
void draw_line(const Vertex& a, const Vertex& b) {
    const std::int64_t round = mistake == 19 ? 0 : half; // down instead of to the nearest
    std::int64_t x = floor_of(a[0] + round);
    std::int64_t y = floor_of(a[1] + round);
    const std::int64_t to_x = floor_of(b[0] + round);
    const std::int64_t to_y = floor_of(b[1] + round);
    const std::int64_t dx = std::abs(to_x - x);
    const std::int64_t dy = std::abs(to_y - y);
    const std::int64_t step_x = to_x < x ? -1 : 1;
    const std::int64_t step_y = to_y < y ? -1 : 1;
    const bool is_x_major = dx >= dy;
    const std::int64_t major = std::max(dx, dy);
    const std::int64_t minor = std::min(dx, dy);
    // What does not fit into 16 bits is cut.
    const auto kept = [](std::int64_t value) {
        return mistake == 22 ? static_cast<std::int16_t>(value) : value;
    };
    std::int64_t d = kept(2 * minor - major);
    for (std::int64_t i = 0; i <= major; ++i) {
        plot(x, y);
        const bool is_diagonal = mistake == 20 ? d >= 0 : d > 0; // a tie goes diagonally
        (is_x_major ? x : y) += is_x_major ? step_x : step_y;
        if (is_diagonal)
            (is_x_major ? y : x) += is_x_major ? step_y : step_x;
        d = kept(d + kept(2 * minor) - (is_diagonal ? kept(2 * major) : 0));
    }
}

} // namespace

int main(int count, char** arguments) {
    if (count < 2)
        return 2;
    mistake = count > 2 ? std::atoi(arguments[2]) : 0;
    const bool has_depth = count > 3 && std::string(arguments[3]) == "depth";
    picture_kind = count > 4 ? arguments[4] : "";
    std::ifstream file(arguments[1]);
    std::string line;
    while (std::getline(file, line)) {
        std::istringstream words(line);
        std::string word;
        std::string name;
        words >> word;
        if (word == "canvas") {
            words >> width >> height;
            depths.resize(static_cast<std::size_t>(width * height));
            picture.resize(depths.size());
            if (!picture_kind.empty())
                continue;
            std::printf("{\"rastertrace\":1,\"canvas\":{\"width\":%d,\"height\":%d,\"origin\":"
                        "\"top-left\"}}\n",
                        width, height);
            continue;
        }
        words >> name;
        std::vector<Vertex> vertices;
        double number = 0;
        for (std::size_t i = 0; words >> number; ++i) {
            if (i % 3 == 0)
                vertices.emplace_back();
            vertices.back()[i % 3] = std::llround(number * one);
        }
        color = static_cast<unsigned>(
            std::strtoul(line.substr(line.rfind('#') + 1).c_str(), nullptr, 16));
        if (picture_kind == "white")
            color = 0xFFFFFF;
        if (picture_kind == "bgr")
            color = (color & 255) << 16 | (color & 0xFF00) | color >> 16;
        begin(word == "tri" ? "triangle" : "line", name);
        if (word == "tri")
            fill({vertices[0], vertices[1], vertices[2]}, has_depth);
        else
            draw_line(vertices[0], vertices[1]);
    }
    if (!picture_kind.empty()) {
        std::printf("P3 %d %d 255\n", width, height);
        for (const unsigned pixel : picture)
            std::printf("%u %u %u\n", pixel >> 16, pixel >> 8 & 255, pixel & 255);
        return 0;
    }
    std::printf("{\"end\":{\"steps\":%d}}\n", steps);
}
