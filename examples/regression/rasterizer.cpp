// SPDX-License-Identifier: MIT
// A rasterizer that knows nothing of rastertrace, and prints what it decides as a trace: a header, a line for each
// decision, and the end. docs/regression-tests.md shows how its trace is tested.
//
//     rasterizer > mine.jsonl
//     rasterizer --fast > fast.jsonl    # with a mistake in it: a cast where floor belongs

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <string>
#include <string_view>
#include <utility>

namespace {

struct Vertex {
    const char* name;
    double x, y; // y points up
};

bool is_fast = false;
int scanlines = 0;
int pixels = 0;

/// Rounds down. The fast way is faster, and wrong to the left of 0.
int rounded(double x) {
    return is_fast ? static_cast<int>(x) : static_cast<int>(std::floor(x));
}

/// Fills a row from one edge to another.
void fill_row(int y, double left, double right, const std::string& left_edge,
              const std::string& right_edge) {
    const int from = rounded(left);
    const int to = rounded(right);
    std::printf(
        "{\"step\":\"scanline\",\"y\":%d,\"left\":%.17g,\"right\":%.17g,\"from\":%d,\"to\":%d,"
        "\"left_edge\":\"%s\",\"right_edge\":\"%s\"}\n",
        y, left, right, from, to, left_edge.c_str(), right_edge.c_str());
    ++scanlines;
    for (int x = from; x <= to; ++x, ++pixels)
        std::printf("{\"step\":\"pixel\",\"x\":%d,\"y\":%d}\n", x, y);
}

/// Goes down from the highest row to the lowest, from edge to edge.
void fill_triangle(const Vertex (&corners)[3]) {
    const auto [low, high] = std::minmax({corners[0].y, corners[1].y, corners[2].y});
    for (int y = static_cast<int>(std::floor(high)); y >= low; --y) {
        double ends[2] = {INFINITY, -INFINITY};
        std::string edges[2];
        for (int i = 0; i < 3; ++i) {
            // The upper vertex comes first, in the edge's name too.
            const auto& [upper, lower] = corners[i].y > corners[(i + 1) % 3].y
                                             ? std::pair(corners[i], corners[(i + 1) % 3])
                                             : std::pair(corners[(i + 1) % 3], corners[i]);
            if (y > upper.y || y < lower.y || upper.y == lower.y)
                continue;
            const double x = upper.x + (upper.x - lower.x) / (upper.y - lower.y) * (y - upper.y);
            const std::string edge = std::string(upper.name) + lower.name;
            if (x < ends[0])
                ends[0] = x, edges[0] = edge;
            if (x > ends[1] || (x == ends[1] && edge != edges[0]))
                ends[1] = x, edges[1] = edge;
        }
        fill_row(y, ends[0], ends[1], edges[0], edges[1]);
    }
}

} // namespace

int main(int count, char** arguments) {
    is_fast = count > 1 && std::string_view(arguments[1]) == "--fast";
    const Vertex corners[3] = {{"A", 2, 5}, {"B", -4, -3}, {"C", 5, -3}};
    std::puts(
        R"({"rastertrace":1,"title":"Mine","canvas":{"width":17,"height":14,"origin":"center"},)"
        R"("method":{"scalar":"double","fill":"scanline","rounding":"floor"}})");
    std::puts(R"({"step":"primitive","kind":"triangle","name":"ABC","vertices":["A","B","C"],)"
              R"("at":[[2,5],[-4,-3],[5,-3]],"color":"#000000"})");
    fill_triangle(corners);
    std::printf(
        "{\"end\":{\"steps\":%d,\"count\":{\"primitive\":1,\"scanline\":%d,\"pixel\":%d}}}\n",
        1 + scanlines + pixels, scanlines, pixels);
}
